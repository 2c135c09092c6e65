"""python -m isthmus: the command of the terminal."""
import sys

from isthmus import command

sys.exit(command.main())
