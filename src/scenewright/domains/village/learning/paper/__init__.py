"""The method of Zhu, Jiang and Li (2022) as printed: views, four kinds of networks, retrieval and
the loop. Needs the extra ``learn``. Ours (``learned``) is what solves; this is what it is compared
with."""
