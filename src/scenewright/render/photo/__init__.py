"""Photographs from inside: light carried from sun, sky and lamps over two bounces, by rays.

A camera is chosen (:mod:`.standpoints`), sources of light are listed (:mod:`.sources`), rays are
followed (:mod:`.following`, kernels in :mod:`.kernels`), noise is taken out (:mod:`.denoising`),
and what is left is developed (:mod:`.developing`).
"""
