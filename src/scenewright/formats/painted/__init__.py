"""Plans as pages paint them: vector PDF and SVG of any program, read as briefs.

What is filled dark is wall, else what the widest pens draw, or a layer named so; gaps, doors and
names are found as in drawings for CAD. The scale is the one that is written on the page (1:50), or
that of the leaves of doors, or ``--scale``.
"""
