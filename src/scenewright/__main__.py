"""``python -m scenewright``: the command line."""

from scenewright import interruption

interruption.install()

from scenewright.cli import main  # noqa: E402 - only after Ctrl-C is obeyed

if __name__ == "__main__":
    main()
