#!/usr/bin/env python3
"""messages.py CORE [APP ...]: the templates of core's messages, for lupdate.

Prints a C++ file with a QT_TRANSLATE_NOOP for each literal in message("...") and
translatable<N>("..."), in the order of files and lines.
"""
import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\\n]|\\.)*"'
TEMPLATE = re.compile(r'\b(?:message|translatable<\d>)\(\s*(' + LITERAL + r'(?:\s*' + LITERAL + r')*)')


def main():
    seen = set()
    for folder in sys.argv[1:]:
        for file in sorted(pathlib.Path(folder).rglob('*')):
            if file.suffix not in ('.cpp', '.h'):
                continue
            for found in TEMPLATE.finditer(file.read_text(encoding='utf-8')):
                words = ''.join(one[1:-1] for one in re.findall(LITERAL, found.group(1)))
                if words not in seen:
                    seen.add(words)
                    print('QT_TRANSLATE_NOOP("ostraka::Error", "%s");' % words)


main()
