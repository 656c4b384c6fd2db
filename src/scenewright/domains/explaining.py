"""A solution explained in words, by the tables its domain states."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence

from scenewright.core.explanation import Advice, Compromise, Explanation, Remark, find_remedy
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.solution import Solution, TermValue
from scenewright.domains.contract import Domain
from scenewright.domains.terrain import describe_ground


def explain_solution(solution: Solution, plan: Plan) -> Explanation:
    """The explanation of a solution: what was decided, what was not placed, what it gives up."""
    domain: Domain = domain_of(solution.brief.domain)
    planted = domain.verb("planting")(solution, plan) if domain.has("planting") else ""
    told = domain.verb("programme") if domain.has("programme") else _count_pieces
    return Explanation(
        solution.brief.name,
        str(told(solution, plan)) + describe_ground(solution, plan) + planted,
        advise(solution, plan.names),
        _list_remarks(solution, plan, domain),
        domain.verb("ledger")(solution, plan) if domain.has("ledger") else (),
    )


def _count_pieces(solution: Solution, plan: Plan) -> str:
    """How much was placed and where, of a domain that decides nothing for the whole."""
    built = [piece for piece in solution.pieces if piece.category == "building"]
    counts = Counter(piece.space for piece in built or solution.pieces)
    parts = [f"{counts[space]} in {name}" for space, name in plan.names.items()]
    return f"{'buildings' if built else 'pieces'} placed: {', '.join(parts)}."


def advise(solution: Solution, names: Mapping[str, str]) -> tuple[Advice, ...]:
    """What was not placed, alike things as one, the required first; ``names`` are what people call
    each space."""
    domain: Domain = domain_of(solution.brief.domain)
    labels, rows = domain.table("labels"), domain.table("remedies")
    counted = Counter(solution.left_out)
    found = [
        Advice(
            names.get(entry.space, entry.space),
            labels.get(entry.what, entry.what).replace("_", " "),
            count,
            entry.reason,
            find_remedy(entry.reason, rows),
            entry.required,
        )
        for entry, count in counted.items()
    ]
    return tuple(sorted(found, key=lambda advice: not advice.required))


def _list_remarks(solution: Solution, plan: Plan, domain: Domain) -> tuple[Remark, ...]:
    """The terms that say something worth a line, a remark a space and term, and what the domain
    says of broken rows; costliest first."""
    table, labels, names = domain.table("compromises"), domain.table("labels"), plan.names
    groups: dict[tuple[str, str], list[TermValue]] = {}
    for term in sorted(solution.terms, key=lambda term: -term.cost):
        if term.term in table and term.value >= table[term.term].least:
            groups.setdefault((term.space, term.term), []).append(term)
    found = [_remark(alike, table[name], names, labels) for (_, name), alike in groups.items()]
    found += domain.verb("faults")(solution, plan) if domain.has("faults") else ()
    return tuple(sorted(found, key=lambda remark: -remark.cost))


def _remark(
    alike: Sequence[TermValue], row: Compromise, names: Mapping[str, str], labels: Mapping[str, str]
) -> Remark:
    """The cost of one term for the items of one space, the worst first."""
    first = alike[0]
    return Remark(
        names.get(first.space, first.space),
        tuple(dict.fromkeys(_name_item(term.item, labels) for term in alike if term.item)),
        first.term,
        row.text.format(value=max(term.value for term in alike)),
        row.remedy,
        sum(term.cost for term in alike),
    )


def _name_item(item: str, labels: Mapping[str, str]) -> str:
    """An item, or a pair of items, in words.

    >>> _name_item("shop/low-shelves & shop/till_2", {"till": "cash desk"})
    'low shelves and cash desk'
    """
    ids = [part.rpartition("/")[2] for part in item.split(" & ")]
    stems = [re.sub(r"_\d+$", "", name) for name in ids]
    return " and ".join(labels.get(stem, re.sub("[_-]", " ", stem)) for stem in stems)
