class ResonanceTable:
    """Resonances."""


def enumerate_resonances(w): ...
