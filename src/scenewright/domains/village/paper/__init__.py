"""The loop of Zhu, Jiang and Li (2022), run by NumPy: views, networks, retrieval."""
