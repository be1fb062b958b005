"""What was typed against the names of actions and other words for them, slips of the hand allowed.

A name answers to the beginnings of its words ("spm" and "split mid" to "Split in the middle") and
to what stands in it; other words answer to their beginnings. What is typed in several words is
looked for word by word.
"""

from __future__ import annotations

from collections.abc import Sequence

# Words that say nothing of what is looked for.
_EMPTY = frozenset(
    {"a", "an", "the", "to", "of", "my", "in", "on", "it", "and", "with", "for", "i"}
)
_RUN, _START = 4, 3
# Of words as long as this, one letter may be wrong.
_LONG = 4


def score(query: str, text: str) -> int | None:
    """Return how well ``query`` matches ``text`` (higher is better), None where it does not.

    Every character of the query, blanks aside, must occur in order, each beginning a word or
    following the one before; or the query occurs as it is.
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
                points + 1 + (_RUN if place == last + 1 else 0) + (_START if starts_word else 0)
                for last, points in best.items()
                if last < place and (starts_word or (place == last + 1 and last >= 0))
            ]
            if candidates:
                reached[place] = max(candidates)
        best = reached
    within = (1 + _RUN) * len(wanted) - _RUN if query.casefold().strip() in folded else 0
    points = max([within, *best.values()])
    # Among equals the shorter name is the nearer one.
    return 100 * points - len(text) if points else None


def also_score(query: str, words: str) -> int | None:
    """Return how well a query is the beginning of one of several other words; None where it is not.

    A little less than a name that begins with it; the first of the words say most.
    """
    wanted, known = query.casefold().strip(), words.casefold().split()
    places = [place for place, word in enumerate(known) if word.startswith(wanted)]
    if len(wanted) < 2 or not places:
        return None
    # A whole word says more than the beginning of one.
    less = 40 + known.index(wanted) if wanted in known else 90 + places[0]
    return 100 * (4 + 5 * (len(wanted) - 1)) - min(less, 139)


def ranked(query: str, texts: Sequence[str], also: Sequence[str] | None = None) -> list[int]:
    """Return the indices of the matching texts, best first, in their own order where equal.

    ``also`` are other words for each of the texts, apart by blanks. Where nothing matches all that
    was typed, words may be longer than those known or have a letter wrong; where even so nothing
    does, any of the words suffices.
    """
    others = also or [""] * len(texts)
    pairs = list(zip(texts, others, strict=True))
    found = [_whole(query, text, words) for text, words in pairs]
    if all(each is None for each in found):
        typed = [word for word in query.casefold().split() if word not in _EMPTY]
        near = [[_near(word, text, words) for word in typed] for text, words in pairs]
        found = [sum(hits) if hits and all(hits) else None for hits in near]
        if all(each is None for each in found) and len(typed) > 1:
            found = [sum(hits) or None for hits in near]
    matching = [(value, index) for index, value in enumerate(found) if value is not None]
    return [index for value, index in sorted(matching, key=lambda pair: (-pair[0], pair[1]))]


def _whole(query: str, text: str, words: str) -> int | None:
    """Return how well all that was typed matches, None where not all of it does."""
    hits = [score(query, text), also_score(query, words)]
    typed = [word for word in query.casefold().split() if word not in _EMPTY]
    if len(typed) > 1:
        each = [_best(score(word, text), also_score(word, words)) for word in typed]
        if None not in each:
            hits.append(sum(hit for hit in each if hit is not None))
    return _best(*hits)


def _best(*hits: int | None) -> int | None:
    return max((hit for hit in hits if hit is not None), default=None)


def _near(word: str, text: str, words: str) -> int:
    """Return how well one word matches when it may be longer or wrong by a letter; 0: not."""
    hit = _best(score(word, text) if len(word) > 2 else None, also_score(word, words))
    if hit is not None:
        return max(hit, 1)
    if len(word) < _LONG:
        return 0
    known = "".join(each if each.isalnum() else " " for each in f"{text} {words}".casefold())
    return max((_alike(word, each) for each in known.split() if len(each) >= _LONG), default=0)


def _alike(word: str, known: str) -> int:
    """Return how nearly a word is another one or its beginning, 0 where it is another word."""
    if word.startswith(known):
        return 100 * len(known)
    if word[0] == known[0] and any(
        _one_slip(word, known[:length]) for length in range(len(word) - 1, len(word) + 2)
    ):
        return 50 * len(word)
    return 0


def _one_slip(word: str, other: str) -> bool:
    """Return whether one letter too many, missing, wrong, or two exchanged make the difference."""
    at = next((k for k, (a, b) in enumerate(zip(word, other, strict=False)) if a != b), None)
    if at is None:
        return abs(len(word) - len(other)) <= 1
    if word[at + 1 :] == other[at + 1 :] or word[at + 1 :] == other[at:]:
        return True
    if word[at:] == other[at + 1 :]:
        return True
    return word[at : at + 2] == other[at : at + 2][::-1] and word[at + 2 :] == other[at + 2 :]
