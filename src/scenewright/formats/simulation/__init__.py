"""Scenes as files of simulators and of judges of scenes."""
