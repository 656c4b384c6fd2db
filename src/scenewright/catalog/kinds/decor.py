"""Textiles, pictures, plants and small things."""

from __future__ import annotations

from scenewright.core.kind import Kind, at_wall, size_range, words

KINDS = (
    Kind(
        "rug",
        flat=True,
        sizes=size_range("40 200 500", "40 140 400", "0.4 1.2 3"),
        words=(
            words(
                en="rug, carpet, doormat, rug round, rug square",
                fr="tapis",
                de="teppich, laufer",
                es="alfombra",
                zh="地毯",
                ja="ラグ, カーペット",
            ),
        ),
        drawn_by=(".furniture.textiles",),
    ),
    Kind(
        "curtain",
        support="wall",
        sizes=size_range("30 180 600", "5 9 25", "50 220 340"),
        words=(
            words(
                en="curtain, curtains, blind, drapes",
                fr="rideau, store",
                de="vorhang, gardine",
                es="cortina",
                zh="窗帘, 窗簾",
                ja="カーテン",
            ),
        ),
        drawn_by=(".furniture.textiles",),
    ),
    Kind(
        "blind",
        support="wall",
        sizes=size_range("30 140 400", "3 6 15", "30 130 320"),
        words=(
            words(
                en="roller blind, roman blind, window blind, window shade",
                fr="store enrouleur, store bateau",
                de="rollo, raffrollo",
                es="estor",
                zh="卷帘, 卷簾",
                ja="ロールスクリーン",
            ),
        ),
        drawn_by=(".furniture.textiles",),
    ),
    Kind(
        "picture",
        support="wall",
        back="flat",
        sizes=size_range("15 70 200", "1.5 4 6", "15 50 140"),
        words=(
            words(
                en="picture, painting, frame, poster, wall art",
                fr="tableau, cadre",
                de="bild, gemalde, bilderrahmen",
                es="cuadro",
                zh="画, 相框",
                ja="絵",
            ),
        ),
        drawn_by=(".furniture.decor",),
    ),
    Kind(
        "wall_clock",
        support="wall",
        sizes=size_range("15 30 60", "2 4 10", "15 30 60"),
        words=(
            words(
                en="clock, wall clock, cuckoo clock",
                fr="horloge",
                de="wanduhr, uhr",
                es="reloj",
                zh="钟, 时钟",
                ja="時計",
            ),
        ),
        drawn_by=(".furniture.decor",),
    ),
    Kind(
        "books",
        support="top",
        sizes=size_range("10 25 90", "10 18 30", "3 10 32"),
        words=(
            words(
                en="book, books", fr="livre, livres", de="bucher", es="libros", zh="书籍", ja="本"
            ),
        ),
        drawn_by=(".furniture.decor",),
    ),
    Kind(
        "plant",
        support="top",
        airy=True,
        sizes=size_range("10 25 55", "10 25 55", "15 40 80"),
        words=(
            words(
                "potted_tree",
                en=(
                    "plant, potted plant, indoor plant, bonsai, bonsai tree, cactus, orchid, "
                    "orchids, fern, spathiphyllum"
                ),
                fr="plante",
                de="pflanze, zimmerpflanze",
                es="planta",
                zh="植物",
                ja="盆栽, 観葉",
            ),
        ),
        in_rooms=(("exterior", ("tree",)),),
        drawn_by=(".furniture.greenery",),
    ),
    Kind(
        "potted_tree",
        airy=True,
        sizes=size_range("30 50 110", "30 50 110", "80 150 240"),
        hall=at_wall(0.15, 0.6),
        words=(
            words(
                "plant",
                en="ficus, palm, yucca, potted palm, potted tree",
                fr="palmier",
                de="palme, zimmerbaum",
                es="palmera",
            ),
        ),
        in_rooms=(("exterior", ("tree",)),),
        forms="plant",
        drawn_by=(".furniture.greenery",),
    ),
    Kind(
        "vase",
        support="top",
        sizes=size_range("7 16 35", "7 16 35", "12 28 80"),
        words=(
            words(
                en="vase, flowers, tulips, bouquet",
                fr="fleurs, vase",
                de="blumen, vase",
                es="jarron, flores",
                zh="花瓶, 花",
                ja="花瓶",
            ),
        ),
        drawn_by=(".furniture.greenery",),
    ),
    Kind(
        "bowl",
        support="top",
        sizes=size_range("10 28 50", "10 28 50", "4 10 22"),
        words=(
            words(
                en="bowl, fruit bowl",
                fr="coupe, saladier",
                de="schale, schussel",
                es="cuenco, frutero",
                zh="碗, 果盘",
                ja="ボウル",
            ),
        ),
        drawn_by=(".furniture.greenery",),
    ),
)
