"""What homes are held to, as tables of rows by room.

No rows, as each needs more than pieces and the floor between them: floor that is cut off and doors
that are shut off (found by walking); aisles beside beds (held for nightstands of their own group,
or the better of two); a sofa and its screen (which of several pairs; off by a right angle it is as
bad as can be); the fireplace; how large a screen its stand holds; shelves along the longest wall;
and what is wrong with a group wherever it stands (``composing/case_faults``:
worktop, work triangle, nightstands).
"""
