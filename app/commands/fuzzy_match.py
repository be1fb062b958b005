"""Fuzzy matching of what was typed against the names of actions."""

from __future__ import annotations


def score(query: str, text: str) -> int | None:
    """Return how well ``query`` matches ``text`` (higher is better), None where it does not.

    Every character of the query, blanks aside, must occur in order. Runs and beginnings of
    words count more, so that "sp" finds "Split" before "Reset shape".
    """
    wanted = [character for character in query.casefold() if not character.isspace()]
    if not wanted:
        return 0
    folded = text.casefold()
    best: dict[int, int] = {-1: 0}
    for character in wanted:
        reached: dict[int, int] = {}
        for place, found in enumerate(folded):
            if found != character:
                continue
            starts_word = place == 0 or not folded[place - 1].isalnum()
            candidates = [
                points + 1 + (4 if place == last + 1 else 0) + (3 if starts_word else 0)
                for last, points in best.items()
                if last < place
            ]
            if candidates:
                reached[place] = max(candidates)
        if not reached:
            return None
        best = reached
    # Among equals the shorter name is the nearer one.
    return 100 * max(best.values()) - len(text)


def also_score(query: str, words: str) -> int | None:
    """Return how well a query is the beginning of one of several other words; None where it is not.

    A little less than a name that begins with it.
    """
    wanted, known = query.casefold().strip(), words.casefold().split()
    if len(wanted) < 2 or not any(word.startswith(wanted) for word in known):
        return None
    # A whole word says more than the beginning of one.
    return 100 * (4 + 5 * (len(wanted) - 1)) - (40 if wanted in known else 60)


def ranked(query: str, texts: list[str], also: list[str] | None = None) -> list[int]:
    """Return the indices of the matching texts, best first, in their own order where equal.

    ``also`` are other words for each of the texts, apart by blanks.
    """
    scores = []
    for index, text in enumerate(texts):
        values = [score(query, text), also_score(query, also[index] if also else "")]
        scores.append((max((v for v in values if v is not None), default=None), index))
    matching = [(value, index) for value, index in scores if value is not None]
    return [index for value, index in sorted(matching, key=lambda pair: (-pair[0], pair[1]))]
