"""Compiled steps of following light: where a ray lands, what falls on it there, where it goes on.

Each is one pass over the rays that are still under way. Light that reaches a surface is sampled
from a source each time (sun; a lamp or a window, taken by what it may give), so that the only rays
that count sky are those that see it through no more than mirrors. Random numbers are a sequence of
low discrepancy turned by a hash of pixel and dimension (R. Cranley, T. Patterson 1976).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.compiled import compiled, inlined
from scenewright.render.finish import PLAIN, _tone
from scenewright.render.light import OFFSET, _between, _cross
from scenewright.render.photo.sky_kernels import _far_trees, _random, _sky

Singles = NDArray[np.float32]
Ints = NDArray[np.int32]
Longs = NDArray[np.int64]
Flags = NDArray[np.bool_]

TURNS = 2.0 * math.pi
MIRROR = 0.6
"""Below this roughness a bounce off the surface of a thing is as off a mirror."""
FAR = 1e4
"""Beyond everything, in metres."""
BESIDE = 0.15
"""How far before a surface, in metres, it is asked in which room that is."""


@compiled
def aim_rays(
    eye: Singles,
    axes: Singles,
    frame: Singles,
    width: int,
    pixels: Ints,
    sample: int,
    starts: Singles,
    ways: Singles,
) -> None:
    """A ray through a random point of each of ``pixels`` (n,). ``axes`` rows are right, up and
    ahead; ``frame`` is left edge, top edge and step of the picture at distance 1 ahead."""
    for i in range(pixels.shape[0]):
        p = pixels[i]
        x = frame[0] + (p % width + _random(p, sample, 0)) * frame[2]
        y = frame[1] - (p // width + _random(p, sample, 1)) * frame[2]
        length = math.sqrt(x * x + y * y + 1.0)
        for k in range(3):
            starts[i, k] = eye[k]
            ways[i, k] = (x * axes[0, k] + y * axes[1, k] + axes[2, k]) / length


@inlined
def _by_cosine(nx: float, ny: float, nz: float, u: float, v: float) -> tuple[float, float, float]:
    """A direction about a normal, by the cosine (T. Duff and others 2017)."""
    sign = 1.0 if nz >= 0.0 else -1.0
    a = -1.0 / (sign + nz)
    b = nx * ny * a
    radius, angle = math.sqrt(u), TURNS * v
    x, y, z = radius * math.cos(angle), radius * math.sin(angle), math.sqrt(max(1.0 - u, 0.0))
    return (
        x * (1.0 + sign * nx * nx * a) + y * b + z * nx,
        x * sign * b + y * (sign + ny * ny * a) + z * ny,
        -x * sign * nx - y * ny + z * nz,
    )


@compiled
def land_rays(
    met: Ints,
    ways: Singles,
    starts: Singles,
    corners: Singles,
    normals: Singles,
    smooth: Flags,
    finishes: Ints,
    table: Singles,
    sky: Singles,
    bare: Flags,
    shade: float,
    paths: Ints,
    through: Singles,
    total: Singles,
    points: Singles,
    facing: Singles,
    body: Singles,
    dull: Singles,
) -> None:
    """Where rays land, the normal turned to them, the colour there and how much of it is no
    mirror's. Rays that leave the scene bring sky if they saw no rough surface yet (``bare``), a
    share ``shade`` of it; things that glow bring their own light."""
    for i in range(met.shape[0]):
        f, p = met[i], paths[i]
        if f < 0:
            if bare[i]:
                trees = _far_trees(ways[i, 0], ways[i, 1], ways[i, 2])
                for k in range(3):
                    light = sky[0, k] * trees if trees > 0.0 else _sky(ways[i, 2], sky, k)
                    total[p, k] += through[i, k] * (light * shade)
            continue
        ux, uy, uz = _cross(corners, f)
        top = low = 0.0
        for k in range(3):
            n = ux if k == 0 else (uy if k == 1 else uz)
            top += n * (corners[f, 0, k] - starts[i, k])
            low += n * ways[i, k]
        t = top / low if low != 0.0 else 0.0
        side = -1.0 if low > 0.0 else 1.0
        for k in range(3):
            points[i, k] = starts[i, k] + t * ways[i, k]
        if smooth[f]:
            ux, uy, uz = _between(
                corners, normals, f, points[i, 0], points[i, 1], points[i, 2], ux, uy, uz
            )
        length = side * math.sqrt(ux * ux + uy * uy + uz * uz)
        facing[i, 0], facing[i, 1], facing[i, 2] = ux / length, uy / length, uz / length
        m = finishes[f]
        dull[i] = 1.0 - table[m, 4]
        tone = 1.0
        if int(table[m, 6]) != PLAIN and abs(facing[i, 2]) > 0.9:
            tone = _tone(int(table[m, 6]), points[i, 0], points[i, 1], 0.0015 * max(t, 0.0))
        for k in range(3):
            body[i, k] = min(table[m, k] * tone, 0.92)
        if table[m, 5] > 0.0 and bare[i]:
            for k in range(3):
                total[p, k] += through[i, k] * table[m, 5] * table[m, k]


@inlined
def _room_at(x: float, y: float, rooms: Ints, ground: Singles) -> int:
    """The number of the room a place is in, -1 for none."""
    row, column = int((y - ground[1]) / ground[2]), int((x - ground[0]) / ground[2])
    if row < 0 or column < 0 or row >= rooms.shape[0] or column >= rooms.shape[1]:
        return -1
    return int(rooms[row, column])


@inlined
def _gift(
    sources: Singles, j: int, links: Singles, room: int, x: float, y: float, z: float
) -> float:
    """About what a source may give to a place: its weight by the distance squared, for windows by
    their width seen from there too; nothing from a window's outer side or to rooms not beside."""
    share = links[room, int(sources[j, 0])]
    if share <= 0.0:
        return 0.0
    dx, dy, dz = sources[j, 2] - x, sources[j, 3] - y, sources[j, 4] - z
    square = max(dx * dx + dy * dy + dz * dz, 0.06)
    if sources[j, 5] > 0.0:
        return float(share * sources[j, 1] / square)
    out = dx * sources[j, 6] + dy * sources[j, 7]
    if out <= 0.02:
        return 0.0
    return float(share * sources[j, 1] * (out / math.sqrt(square) + 0.1) / square)


@inlined
def _choose(
    sources: Singles, links: Singles, room: int, x: float, y: float, z: float, share: float
) -> tuple[int, float]:
    """A source drawn by what it may give, and the chance it had; -1 if none gives anything."""
    whole = 0.0
    for j in range(sources.shape[0]):
        whole += _gift(sources, j, links, room, x, y, z)
    left, chosen, chance = share * whole, -1, 0.0
    for j in range(sources.shape[0]):
        gift = _gift(sources, j, links, room, x, y, z)
        if gift <= 0.0:
            continue
        chosen, chance = j, gift / whole
        left -= gift
        if left <= 0.0:
            break
    return chosen, chance


@compiled
def ask_sun(
    sample: int,
    bounce: int,
    paths: Ints,
    points: Singles,
    facing: Singles,
    dull: Singles,
    sun: Singles,
    starts: Singles,
    to_sun: Singles,
    from_sun: Singles,
) -> None:
    """For each landed ray, a ray to a point of the sun's disc, and the light it brings to a white
    surface if nothing is in between. ``sun`` rows: two directions across it by its radius, the one
    to it, its light. ``starts`` are ``points`` a little off their surfaces."""
    for i in range(paths.shape[0]):
        p, dim = paths[i], 2 + 8 * bounce
        angle = TURNS * _random(p, sample, dim)
        radius = math.sqrt(_random(p, sample, dim + 1))
        across, along = radius * math.cos(angle), radius * math.sin(angle)
        cosine = 0.0
        for k in range(3):
            starts[i, k] = points[i, k] + OFFSET * facing[i, k]
            to_sun[i, k] = across * sun[0, k] + along * sun[1, k] + sun[2, k]
            cosine += to_sun[i, k] * facing[i, k]
        for k in range(3):
            from_sun[i, k] = dull[i] / math.pi * max(cosine, 0.0) * sun[3, k]


@inlined
def _point_of(sources: Singles, j: int, u: float, v: float) -> tuple[float, float, float]:
    """A point of a lamp's ball or a window."""
    wide = sources[j, 5]
    if wide > 0.0:
        turn, height = TURNS * u, 2.0 * v - 1.0
        level = math.sqrt(max(1.0 - height * height, 0.0)) * wide
        x = sources[j, 2] + level * math.cos(turn)
        return x, sources[j, 3] + level * math.sin(turn), sources[j, 4] + height * wide
    aside = (u - 0.5) * sources[j, 8]
    x = sources[j, 2] - sources[j, 7] * aside
    return x, sources[j, 3] + sources[j, 6] * aside, sources[j, 4] + (v - 0.5) * sources[j, 9]


@compiled
def ask_sources(
    sample: int,
    bounce: int,
    paths: Ints,
    facing: Singles,
    dull: Singles,
    sky: Singles,
    sources: Singles,
    links: Singles,
    rooms: Ints,
    ground: Singles,
    starts: Singles,
    ways: Singles,
    reach: Singles,
    brought: Singles,
) -> None:
    """For each landed ray, a ray to a lamp or window drawn by what it may give, out of doors into
    the sky, and the light it brings to a white surface if nothing is nearer than ``reach``.

    ``sources`` (k, 11): room, weight, middle, radius, and for lamps (radius above 0) their light,
    for windows the way out in plan, width, height and the share of light let through. ``rooms`` is
    a raster of room numbers over ``ground`` (left, low, cell), ``links`` (r, r) how far light gets
    from room to room.
    """
    for i in range(paths.shape[0]):
        p, dim = paths[i], 2 + 8 * bounce
        nx, ny, nz = facing[i, 0], facing[i, 1], facing[i, 2]
        x, y, z = starts[i, 0], starts[i, 1], starts[i, 2]
        u, v = _random(p, sample, dim + 2), _random(p, sample, dim + 3)
        room = _room_at(x + BESIDE * nx, y + BESIDE * ny, rooms, ground)
        if room < 0:
            ways[i, 0], ways[i, 1], ways[i, 2] = _by_cosine(nx, ny, nz, u, v)
            reach[i] = FAR
            for k in range(3):
                brought[i, k] = dull[i] * _sky(ways[i, 2], sky, k)
            continue
        j, chance = _choose(sources, links, room, x, y, z, _random(p, sample, dim + 4))
        if j < 0:
            continue
        px, py, pz = _point_of(sources, j, u, v)
        square = max((px - x) ** 2 + (py - y) ** 2 + (pz - z) ** 2, 1e-4)
        away = math.sqrt(square)
        dx, dy, dz = (px - x) / away, (py - y) / away, (pz - z) / away
        share = dull[i] * (dx * nx + dy * ny + dz * nz) / (math.pi * max(square, 0.02) * chance)
        wide = sources[j, 5]
        if wide <= 0.0:
            share *= sources[j, 10] * sources[j, 8] * sources[j, 9]
            share *= max(dx * sources[j, 6] + dy * sources[j, 7], 0.0)
        ways[i, 0], ways[i, 1], ways[i, 2] = dx, dy, dz
        reach[i] = away - 2.0 * wide - 0.01 if wide > 0.0 else (FAR if dz >= 0.0 else away + 1.0)
        for k in range(3):
            light = sources[j, 6 + k] if wide > 0.0 else _sky(dz, sky, k)
            brought[i, k] = max(share, 0.0) * light


@compiled
def gather_light(
    paths: Ints,
    asked: Longs,
    hidden: Flags,
    through: Singles,
    body: Singles,
    brought: Singles,
    most: float,
    total: Singles,
) -> None:
    """Add what is brought by the rays ``asked`` that nothing stands in the way of, ``most`` at
    most, by the colour of the surface and what the path lets through."""
    for a in range(asked.shape[0]):
        i = asked[a]
        if hidden[a]:
            continue
        top = 0.0
        for k in range(3):
            top = max(top, through[i, k] * body[i, k] * brought[i, k])
        less = most / top if top > most else 1.0
        for k in range(3):
            total[paths[i], k] += through[i, k] * body[i, k] * brought[i, k] * less


@compiled
def send_on(
    sample: int,
    bounce: int,
    paths: Ints,
    met: Ints,
    finishes: Ints,
    table: Singles,
    points: Singles,
    facing: Singles,
    body: Singles,
    starts: Singles,
    ways: Singles,
    through: Singles,
    bare: Flags,
) -> None:
    """Where each ray goes on: off the surface as off a mirror blurred by its roughness, with the
    chance that C. Schlick's formula (1994) gives, else into the half space by the cosine."""
    for i in range(paths.shape[0]):
        p, m, dim = paths[i], finishes[met[i]], 7 + 8 * bounce
        rough, metal = table[m, 3], table[m, 4]
        along = 0.0
        for k in range(3):
            along -= ways[i, k] * facing[i, k]
        grazing = (1.0 - min(max(along, 0.0), 1.0)) ** 5
        shine = (1.0 - rough) ** 2
        chance = metal + (1.0 - metal) * (0.04 + 0.96 * grazing) * shine
        chance = min(max(chance, 0.0), 1.0)
        u, v = _random(p, sample, dim + 1), _random(p, sample, dim + 2)
        mirrored = _random(p, sample, dim) < chance
        nx, ny, nz = facing[i, 0], facing[i, 1], facing[i, 2]
        hx, hy, hz = _by_cosine(nx, ny, nz, u, v)
        if mirrored:
            blur = rough * rough
            hx = ways[i, 0] + 2.0 * along * nx + blur * (hx - nx)
            hy = ways[i, 1] + 2.0 * along * ny + blur * (hy - ny)
            hz = ways[i, 2] + 2.0 * along * nz + blur * (hz - nz)
            length = math.sqrt(hx * hx + hy * hy + hz * hz)
            hx, hy, hz = hx / length, hy / length, hz / length
            bare[i] = bare[i] and rough < MIRROR
        else:
            bare[i] = False
        tint = metal if mirrored else 1.0
        for k in range(3):
            through[i, k] *= tint * body[i, k] + 1.0 - tint
            starts[i, k] = points[i, k] + OFFSET * facing[i, k]
        ways[i, 0], ways[i, 1], ways[i, 2] = hx, hy, hz
