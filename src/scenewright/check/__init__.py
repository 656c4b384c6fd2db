"""The referee's shared part: is the answer right? Exact geometry on the final pieces.

It shares no code with what it judges: it sees the brief, the rooms made of it and the pieces,
never patches, costs or kernels. Each domain's package ``check`` adds the rules of its own.
Definitions follow SceneEval (Tam, Pun, Wang, Chang, Savva 2025, "SceneEval: Evaluating Semantic
Coherence in Text-Conditioned 3D Indoor Scene Synthesis"); where ours differ the module of the test
says how.
"""
