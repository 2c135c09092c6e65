#!/usr/bin/env python3
"""Draws sentences of user-visible text at random, to be judged by a reader without their context.

    sample_sentences.py SEED [NUMBER]

The texts are those of check_idioms.py; what begins in the middle of a sentence, as a part of a message does, is left
out. Prints a table in Markdown: number, file and line, sentence. The same
seed draws the same sentences from the same commit. NUMBER is 200 by default.
"""
import pathlib
import random
import re
import sys

import check_idioms

ROOT = pathlib.Path(__file__).resolve().parents[1]


def plain(text):
    """Text without the frames of comments and the marks of Markdown."""
    text = re.sub(r"^\s*(?:///?<?|/?\*+/?)|@(?:file|brief)\s+(?:\w+[.]h\b)?", "", text, flags=re.MULTILINE)
    return re.sub(r"[*`\[]|\\n|\\\"", "", text)


def sentences(root):
    for path, relative in check_idioms.files_of(root):
        for line, text in check_idioms.texts_of(path, relative, with_code=True):
            for paragraph in re.split(r"\n\s*\n|\n\s*(?=[-|#])", plain(text)):
                for sentence in re.split(r"(?<=[.!?])\s+(?=[A-Z])", " ".join(paragraph.split())):
                    if len(sentence.split()) >= 6 and "|" not in sentence and re.match(r"[A-Z0-9(].*[.!?]$", sentence):
                        yield str(relative), line, sentence


def main():
    seed = int(sys.argv[1])
    number = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    found = sorted(set(sentences(ROOT)))
    print(f"{number} of {len(found)} sentences, seed {seed}\n\n| | where | sentence |\n|---|---|---|")
    for i, (where, line, sentence) in enumerate(random.Random(seed).sample(found, number), 1):
        print(f"| {i} | {where}:{line} | {sentence} |")


if __name__ == "__main__":
    main()
