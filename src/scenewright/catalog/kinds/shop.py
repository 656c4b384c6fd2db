"""Shelves, rails and tills of shops, and library stacks."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, BOTH, FRONT
from scenewright.core.kind import Kind, at_wall, free, size_range, words

KINDS = (
    Kind(
        "gondola",
        access=BOTH,
        reach=0.6,
        sizes=size_range("50 125 250", "50 90 140", "110 160 240"),
        hall=free("chain", 0.7, 0.0, 0.7, 0.0),
        words=(
            words(
                en="gondola shelf, supermarket shelf, store shelf",
                fr="gondole de magasin",
                de="gondelregal, verkaufsregal, supermarktregal",
                es="góndola de supermercado",
                zh="货架, 超市货架",
                ja="ゴンドラ什器, 商品棚",
            ),
        ),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "wall_shelving",
        access=FRONT,
        reach=0.6,
        sizes=size_range("50 125 250", "25 45 80", "110 210 270"),
        hall=at_wall(0.75),
        words=(
            words(
                en="wall shelving, retail wall shelf",
                fr="rayonnage mural",
                de="wandregalsystem, ladenwandregal",
                es="estantería mural de tienda",
                zh="靠墙货架",
                ja="壁面什器",
            ),
        ),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "ring_shelf",
        access=FRONT,
        reach=0.6,
        sizes=size_range("40 100 250", "25 45 80", "90 150 230"),
        hall=free("circulation chain", 0.75, 0.0, 0.0, 0.0),
        words=(
            words(
                en="ring shelf, curved shelf",
                fr="étagère courbe",
                de="rundregal, bogenregal",
                es="estantería curva",
                zh="弧形货架",
                ja="曲線棚",
            ),
        ),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "fridge_shelf",
        label="cooler with glass doors",
        access=FRONT,
        reach=0.75,
        sizes=size_range("60 130 400", "45 75 120", "130 205 240"),
        hall=at_wall(0.75),
        words=(
            words(
                en="glass door cooler, refrigerated shelf, display fridge, display refrigerator",
                fr="vitrine réfrigérée",
                de="kühlregal, getränkekühlschrank",
                es="vitrina refrigerada",
                zh="冷藏展示柜, 冷柜",
                ja="冷蔵ショーケース",
            ),
        ),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "book_stack",
        access=BOTH,
        reach=0.6,
        sizes=size_range("60 100 600", "35 50 80", "90 200 250"),
        hall=free("chain", 0.6, 0.0, 0.6, 0.0),
        words=(
            words(
                en="library shelf, book stack, library stack",
                fr="rayonnage de bibliothèque",
                de="bibliotheksregal",
                es="estantería de biblioteca",
                zh="图书馆书架",
                ja="図書館書架",
            ),
        ),
        drawn_by=(".public.gondolas",),
    ),
    Kind(
        "clothes_rail",
        access=BOTH,
        reach=0.6,
        sizes=size_range("60 130 250", "35 55 80", "110 140 180"),
        hall=free("chain grid", 0.6, 0.2, 0.6, 0.2),
        words=(
            words(
                en="clothes rail, clothing rail, garment rack, clothing rack",
                fr="portant, portant à vêtements",
                de="kleiderstange, garderobenstange",
                es="burro de ropa, perchero de tienda",
                zh="挂衣架, 服装架",
                ja="ハンガーラック",
            ),
        ),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "round_rack",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("70 110 160", "70 110 160", "110 135 160"),
        hall=free("grid chain", 0.6),
        words=(
            words(
                en="round rack, round clothing rack, circular clothes rack",
                fr="portant rond, portant circulaire",
                de="rundständer, kleiderkarussell",
                es="perchero circular",
                zh="圆形衣架",
                ja="丸ハンガーラック",
            ),
        ),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "mannequin",
        sizes=size_range("35 50 80", "25 40 80", "120 182 210"),
        hall=free("grid chain single", 0.3),
        words=(
            words(
                en="mannequin, manikin, dress form",
                fr="mannequin",
                de="schaufensterpuppe, mannequin",
                es="maniquí",
                zh="人体模特, 模特",
                ja="マネキン",
            ),
        ),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "display_table",
        access=ALL_SIDES,
        reach=0.6,
        sizes=size_range("70 140 240", "50 80 150", "60 90 130"),
        hall=free("grid chain radiation", 0.6),
        words=(
            words(
                en="display table, nesting display table, retail table",
                fr="table de présentation",
                de="präsentationstisch, verkaufstisch",
                es="mesa expositora",
                zh="展示桌, 陈列桌",
                ja="陳列台, ディスプレイテーブル",
            ),
        ),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "checkout",
        access=FRONT,
        reach=0.9,
        sizes=size_range("120 220 400", "80 120 250", "90 130 160"),
        hall=free("chain single", 0.9, 0.0, 0.6, 0.0),
        staff=0.9,
        words=(
            words(
                en="checkout, checkout counter, cash desk, cash register counter, supermarket till",
                fr="meuble caisse, caisse de supermarché",
                de="kassentisch, kassentheke",
                es="caja registradora, mueble de caja",
                zh="收银台",
                ja="レジカウンター, レジ台",
            ),
        ),
        drawn_by=(".public.tills",),
    ),
    Kind(
        "fitting_room",
        access=FRONT,
        reach=0.9,
        sizes=size_range("75 100 180", "75 110 200", "190 215 270"),
        hall=at_wall(0.9),
        words=(
            words(
                en="fitting room, changing room, dressing cubicle",
                fr="cabine d'essayage",
                de="umkleidekabine, ankleidekabine",
                es="probador",
                zh="试衣间, 更衣间",
                ja="試着室, フィッティングルーム",
            ),
        ),
        drawn_by=(".public.shop",),
    ),
    Kind(
        "basket_stack",
        access=ALL_SIDES,
        reach=0.45,
        sizes=size_range("30 45 70", "25 34 50", "35 80 130"),
        hall=free("single chain", 0.3),
        words=(
            words(
                en="shopping basket, shopping baskets, basket stack",
                fr="panier de courses",
                de="einkaufskorb",
                es="cesta de la compra",
                zh="购物篮",
                ja="買い物かご",
            ),
        ),
        drawn_by=(".public.shop",),
    ),
)
