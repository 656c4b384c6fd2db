"""Machines that serve whoever stands before them: cash, tickets and copies."""

from __future__ import annotations

from itertools import pairwise

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    CHARCOAL,
    PAPER,
    SCREEN,
    STEEL,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, box, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import rotate_mesh
from scenewright.geometry.solids import block

FACE = 0.12
"""How far the head of a machine lies behind its ledge, as a share of the depth."""


def _build(size: Size, head: Stuff) -> Parts:
    """A pedestal with a ledge, and a head set back above it with what is in its face."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top, face = 0.58 * h, d - 2 * FACE * d
    found: Stuff = {
        STEEL: [block((-w, w), (-d, d - 0.004), (0.06, top))],
        ACCENT: [block((-w, w), (-d, face), (0.9 * h, h))],
        WHITE: [block((-w, w), (-d, face), (top, 0.9 * h))],
        BLACK: [block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.05), (0, 0.06))],
    }
    for material, meshes in head.items():
        found[material] = [*found.get(material, []), *meshes]
    return parts(size, found)


def _cash_machine(size: Size) -> Parts:
    """A screen, keys on a ledge below, a slot for cards and one for notes."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top, face = 0.58 * h, d - 2 * FACE * d
    keys = [
        block((x - 0.02, x + 0.02), (y - 0.015, y + 0.015), (top, top + 0.012))
        for x in (-0.05, 0.0, 0.05)
        for y in (face + 0.3 * (d - face), face + 0.65 * (d - face))
    ]
    return _build(
        size,
        {
            SCREEN: [block((-0.6 * w, 0.35 * w), (face, face + 0.006), (0.64 * h, 0.84 * h))],
            BLACK: [
                block((0.5 * w, 0.85 * w), (face, face + 0.008), (0.78 * h, 0.8 * h)),
                block((-0.55 * w, 0.55 * w), (d - 0.004, d), (0.45 * h, 0.48 * h)),
            ],
            CHARCOAL: keys,
        },
    )


def _ticket_machine(size: Size) -> Parts:
    """A large tilted screen, a slot for money and a tray for tickets behind a flap."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top, face = 0.58 * h, d - 2 * FACE * d
    flat = block((-0.7 * w, 0.3 * w), (face - 0.01, face + 0.006), (0.61 * h, 0.87 * h))
    shown = rotate_mesh(flat, "x", 0.06, (0.0, face, 0.61 * h))
    return _build(
        size,
        {
            SCREEN: [shown, block((0.45 * w, 0.8 * w), (face, face + 0.006), (0.7 * h, 0.76 * h))],
            PAPER: [block((-0.1 * w, 0.1 * w), (face + 0.02, d - 0.02), (top, top + 0.004))],
            BLACK: [
                block((0.5 * w, 0.75 * w), (face, face + 0.008), (0.8 * h, 0.82 * h)),
                block((-0.45 * w, 0.45 * w), (d - 0.004, d), (0.3 * h, 0.42 * h)),
            ],
        },
    )


def _screen_symbol(size: Size) -> Lines:
    """The ledge before the head, and the screen in its face."""
    w, d = size.width / 2, size.depth / 2
    face = d - 2 * FACE * d
    return (
        rectangle(size),
        path((-w, face), (w, face)),
        box(-0.6 * w, 0.4 * w, face - 0.12 * d, face),
    )


def _copier(size: Size) -> Parts:
    """Drawers for paper below a slot with a tray of copies, a glass under a lid that feeds sheets,
    and keys beside a small screen before it."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    slot, bed, lid = 0.6 * h, 0.72 * h, 0.9 * h
    face, back = d - 0.02, -0.1 * d
    ends = [0.06 + share * (slot - 0.08) for share in (0.0, 1 / 3, 2 / 3, 1.0)]
    drawers = [
        block((-w + 0.02, w - 0.02), (face, d), (low + 0.01, high - 0.01))
        for low, high in pairwise(ends)
    ]
    grips = [
        block((-0.3 * w, 0.3 * w), (d - 0.004, d + 0.004), (high - 0.04, high - 0.025))
        for high in ends[1:]
    ]
    found: Stuff = {
        WHITE: [
            block((-w, w), (-d, face), (0.06, slot)),
            block((-w, w), (-d, back), (slot, bed)),
            block((-w, -0.8 * w), (back, face), (slot, bed)),
            block((-w, w), (-d, face), (bed, 0.8 * h)),
            *drawers,
        ],
        CHARCOAL: [
            block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.05), (0, 0.06)),
            block((-w, 0.7 * w), (-d, 0.5 * d), (0.8 * h, lid)),
            block((-0.8 * w, 0.2 * w), (-0.8 * d, 0.1 * d), (lid, h)),
        ],
        PAPER: [block((-0.5 * w, 0.6 * w), (back, 0.8 * d), (slot, slot + 0.02))],
        SCREEN: [block((0.1 * w, 0.7 * w), (0.55 * d, 0.9 * d), (0.8 * h, 0.8 * h + 0.01))],
        BLACK: grips,
    }
    return parts(size, found)


def _copier_symbol(size: Size) -> Lines:
    """The lid, and the keys before it."""
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), box(-w, 0.7 * w, -d, 0.5 * d), box(0.1 * w, 0.7 * w, 0.55 * d, 0.9 * d)


_CASH = "cash atm bank bancomat bankomat geldautomat cajero 取款机 自动取款机"
_TICKETS = (
    "ticket fare fahrkarte fahrkartenautomat fahrschein ticketautomat billet billets boleto "
    "boletos 售票机 自动售票机 券売機"
)

ASSETS = (
    Drawing("cash_machine", _cash_machine, _screen_symbol),
    Drawing("ticket_machine", _ticket_machine, _screen_symbol),
    Drawing("copier", _copier, _copier_symbol),
    Drawing(
        "vending_machine",
        _cash_machine,
        _screen_symbol,
        id="vending_machine_cash",
        name="Cash machine",
        called=tuple(_CASH.split()),
    ),
    Drawing(
        "vending_machine",
        _ticket_machine,
        _screen_symbol,
        id="vending_machine_tickets",
        name="Ticket machine",
        called=tuple(_TICKETS.split()),
    ),
)
