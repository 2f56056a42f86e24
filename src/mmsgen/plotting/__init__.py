"""Figures: Matplotlib axes that a user can restyle. Needs the extra ``plot``.

Colours are those of Okabe and Ito (2008), which stay apart for colour-blind readers; lines differ
in dash or width as well, so that they stay apart in grey. Sizes are for print: a figure of one
panel for a column of 90 mm, wider ones for the width of a page, without letters below 6 points.
Every function draws on the axes that it is given, or on new ones, and returns them; what it draws
has labels, by which it can be found.
"""

from .charts import stability_chart
from .growth import convergence, growth_rates
from .motions import time_response
from .responses import backbone, frequency_response
from .style import COLOURS, DASHES, MARKERS, WIDTHS, shared_legend

__all__ = [
    "COLOURS",
    "DASHES",
    "MARKERS",
    "WIDTHS",
    "backbone",
    "convergence",
    "frequency_response",
    "growth_rates",
    "shared_legend",
    "stability_chart",
    "time_response",
]
