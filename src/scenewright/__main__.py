"""``python -m scenewright``: the command line."""

from scenewright.cli import main

if __name__ == "__main__":
    main()
