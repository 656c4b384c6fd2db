"""Words of no single kind: those of several, and those of what is no furniture of ours.

The latter keep a name from meaning what only a part of it says: a *piano bench* is no piano.
"""

from __future__ import annotations

from typing import NamedTuple

from scenewright.core.kind import Words, words


class Generic(NamedTuple):
    """Words for several kinds, apart by size and by how high they hang, and what they mean in a
    room."""

    kinds: tuple[str, ...]
    words: Words
    in_rooms: tuple[tuple[str, tuple[str, ...]], ...] = ()


GENERIC: dict[str, Generic] = {
    "lamp": Generic(
        ("table_lamp", "floor_lamp", "pendant_lamp", "ceiling_lamp"),
        words(
            en="lamp, light, uplight lamp",
            fr="lampe",
            de="leuchte, lampe",
            es="lampara",
            zh="灯, 燈",
            ja="ランプ, ライト",
        ),
        (("exterior", ("lamp_post",)),),
    ),
    "cabinet": Generic(
        (
            "wardrobe",
            "chest_of_drawers",
            "sideboard",
            "display_cabinet",
            "wall_cabinet",
            "bookcase",
        ),
        words(
            en="cabinet, cupboard",
            fr="placard, meuble",
            de="schrank",
            es="armario bajo, mueble",
            zh="柜, 櫃, 箱子",
            ja="キャビネット",
        ),
        (
            ("kitchen", ("base_cabinet", "wall_cabinet", "tall_cabinet")),
            ("bathroom", ("bathroom_cabinet",)),
            ("office", ("shelf_unit", "bookcase", "chest_of_drawers")),
        ),
    ),
}

NO_KIND: tuple[Words, ...] = (
    words(
        en="shower head, shower head and faucet, shower door, shower screen, bath mat",
        fr="pommeau de douche",
        de="brausekopf",
        es="alcachofa de ducha",
    ),
    words(
        en=(
            "wall spotlight, wall uplight, camping lamp, outdoor lamp, "
            "porch light, stone lantern, traffic light, fluorescent light, fluorescent strip, "
            "track lights, candle, flashlight"
        )
    ),
    words(
        en=(
            "ceiling fan, fan, table fan, table tennis, table tennis bat, pool table, billiard "
            "table, table football, football table, ping pong table, table cloth, tablecloth"
        ),
        fr="ventilateur, nappe, billard",
        de="ventilator, tischdecke",
        es="ventilador, mantel",
    ),
    words(
        en="chess table, changing table, operating table, massage table",
        fr="table a langer",
        de="wickeltisch",
        es="cambiador",
    ),
    words(
        en="piano bench, abdominal bench, work bench, workbench, saw bench, weight bench",
        fr="etabli",
        de="werkbank",
        es="banco de trabajo",
        zh="腹部的长凳, 钳工台",
    ),
    words(
        en="grand piano, electric piano, keyboard",
        fr="piano a queue",
        de="flugel",
        es="piano de cola",
    ),
    words(
        en=(
            "wheel chair, wheelchair, child chair, children chair, high chair, folding chair "
            "low, baby chair, potty chair, car seat, toilet seat, class seat, ryokan chair"
        ),
        fr="fauteuil roulant, chaise haute",
        de="rollstuhl, hochstuhl",
        es="silla de ruedas, trona",
        zh="轮椅",
    ),
    words(en="armchair ottoman, children table, dolls table"),
    words(
        en="toilet paper, toilet paper dispenser, toilet brush, toilet roll, urinal, bidet, potty",
        fr="papier toilette, urinoir, bidet",
        de="toilettenpapier, urinal, bidet",
        es="papel higienico, urinario, bide",
    ),
    words(
        en=(
            "bed linen, sleeping bag, pillow, cushion, blanket, mattress, bed sheet, flower bed, "
            "truck bed, dog bed, cat bed, hospital bed"
        ),
        fr="coussin, oreiller, matelas",
        de="kissen, matratze",
        es="cojin, almohada, colchon",
        zh="枕头",
        ja="枕",
    ),
    words(
        en=(
            "door, window, doorway, screen door, glass door, garage door, window shutter, gate, "
            "door frame, sliding door, wall, wall corner, floor, doormat door"
        ),
        fr="porte, fenetre, volet",
        de="tur, fenster",
        es="puerta, ventana",
        zh="门, 窗",
        ja="ドア, 窓",
    ),
    words(
        en=(
            "wall socket, wall double socket, socket, switch, plug, wall switch, outlet, smoke "
            "detector, extinguisher"
        ),
        fr="prise, interrupteur",
        de="steckdose, schalter",
        es="enchufe, interruptor",
    ),
    words(
        en=(
            "coffee cup, coffee mug, coffee maker, coffee brewer, coffee machine, coffee press, "
            "coffee, tea cup, cup, glass, beer glass, bottle, plate, knife stand, cake stand, "
            "music stand, bread box, lunch box, tool box, mail box, mailbox, letter box, ammo "
            "box, box of tissues, spray, chess, chessboard"
        ),
        fr="tasse, verre, bouteille, assiette",
        de="tasse, glas, flasche, teller",
        es="taza, vaso, botella, plato",
    ),
    words(
        en=(
            "board, white board, whiteboard, chopping board, cutting board, black board, "
            "blackboard, emergency sign, sign, picture book, kitchen knife, kitchen scale, "
            "kitchen tools, car, toy car, car model, toy train, toy, truck, bus"
        ),
        fr="tableau blanc, panneau",
        de="tafel, schild",
        es="pizarra, cartel",
    ),
    words(
        en=(
            "christmas tree, tree house, tree stump, plant pot empty, house, tent, hut, fence, "
            "railing, hedge, barbecue"
        ),
        fr="sapin de noel, maison, tente, haie",
        de="weihnachtsbaum, haus, zelt, hecke, zaun",
        es="casa, tienda, valla",
    ),
    words(
        en=(
            "microwave, microwave oven, oven glove, oven mitt, small oven, pizza oven, toaster "
            "oven, kettle"
        ),
        fr="micro ondes",
        de="mikrowelle",
        es="microondas",
        zh="微波炉",
        ja="電子レンジ",
    ),
    words(
        en=(
            "computer mouse, computer keyboard, computer, game console, play station, remote, tv "
            "remote, tv remote control, tv antenna, television antenna"
        ),
        fr="souris, clavier",
        de="maus, tastatur",
        es="raton, teclado",
    ),
    words(
        en=(
            "safe, suitcase, clothes rack, clothes, coat hanger, wire coathanger, coat, towel, hat"
        ),
        fr="valise, vetements",
        de="koffer, kleider",
        es="maleta, ropa",
    ),
    words(
        en=(
            "kitchen bar, kitchen bar end, upper corner cabinet, kitchen upper corner cabinet, "
            "washer dryer, water heater, storage heater, island extension"
        )
    ),
)
