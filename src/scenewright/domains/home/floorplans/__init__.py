"""Floor plans of homes, made from a programme and an outline: rooms, walls, doors and windows.

Rooms are the leaves of slicing trees (Otten 1982) written as normalised Polish expressions and
annealed (Wong, Liu 1986), which keeps every wall straight and every floor covered; what a tree does
not guarantee, that rooms are wide enough, lit and reached, is its cost. Homes of several storeys
share a hall with the stairs, and each storey fills the blocks around it. Doors and windows follow.
"""
