"""What emitted packages share, and the engine uses as well: plain NumPy, copied as it stands.

A module ``_x`` here becomes ``mms_functions/_x.py``: it may import NumPy and its neighbours, and
nothing else.
"""
