"""Functions emitted by mmsgen: a subpackage for each model, in it a module for each case.

Importing needs NumPy alone.
"""
