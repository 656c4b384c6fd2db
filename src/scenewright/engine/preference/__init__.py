"""What a person likes, learned from what she says about layouts; knows no kind of scene.

Layouts are rows of feature values and numbers of candidates. Two families live here: a Gaussian
process over features with a choice likelihood (ours), and the allele preferences, sub-space models
and ART1 network of Zhang, Yang 2023 (as printed and repaired).
"""
