"""The person in the loop as Zhang and Yang (2023) have it: preferences of alleles, (7) to (25).

Individuals are rows of alleles, one a gene; an allele is a value at a gene. Each function has the
form ``printed`` and, where the print fails, ``repaired``.
"""
