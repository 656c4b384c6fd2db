"""Textures made from formulas: seamless, in metres, the same bytes each time.

A generator draws a surface (:mod:`.generators` on the noise of :mod:`.noise`), a table says which
material wears which and how large it is (:mod:`.table`), and places on it are laid over the faces
of a part by their directions (:mod:`.projection`).
"""
