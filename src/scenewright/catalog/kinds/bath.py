"""Bathrooms and toilets."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FRONT, PIPE, TRAY
from scenewright.core.kind import Kind, size_range, words

KINDS = (
    Kind(
        "toilet",
        access=FRONT,
        back="high",
        sizes=size_range("33 38 45", "48 66 76", "70 78 92"),
        services=(PIPE,),
        words=(
            words(
                en="toilet, toilets, wc, water closet",
                fr="toilettes, cuvette",
                de="toilette, klo",
                es="inodoro, retrete",
                zh="马桶, 坐便器",
                ja="便器",
            ),
        ),
        essential=("bath, shower or toilet", "toilet"),
        forms="toilet",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "basin",
        label="basin cabinet",
        access=FRONT,
        sizes=size_range("45 80 160", "30 48 60", "78 88 100"),
        services=(PIPE,),
        words=(
            words(
                "pedestal_basin",
                en="bathroom vanity, bathroom sink",
                fr="meuble vasque",
                de="waschtisch",
                es="mueble de lavabo",
                zh="浴室柜",
                ja="洗面台",
            ),
            words(
                "pedestal_basin",
                en="washbasin, wash basin, basin, handbasin",
                fr="lavabo, vasque",
                de="waschbecken",
                es="lavabo",
                zh="洗手盆, 面盆, 洗脸盆",
                ja="洗面器",
            ),
        ),
        essential=("basin", "basin or washing machine"),
        forms="basin",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "pedestal_basin",
        access=FRONT,
        sizes=size_range("30 50 70", "24 42 56", "76 86 95"),
        services=(PIPE,),
        words=(
            words(
                en="pedestal basin, pedestal washbasin, pedestal sink",
                fr="lavabo sur colonne",
                de="standwaschbecken",
                es="lavabo de pedestal",
                zh="立柱盆",
            ),
        ),
        essential=("basin", "basin or washing machine"),
        forms="basin",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "bathtub",
        access=FRONT,
        sizes=size_range("100 170 195", "60 75 110", "45 58 70"),
        services=(TRAY,),
        words=(
            words(
                en="bathtub, bath tub, bath, island bath",
                fr="baignoire",
                de="badewanne",
                es="banera",
                zh="浴缸",
                ja="バスタブ, 浴槽",
            ),
        ),
        essential=("bath, shower or toilet",),
        forms="bath",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "shower",
        access=FRONT,
        sizes=size_range("65 90 165", "65 90 125", "185 200 225"),
        services=(TRAY,),
        words=(
            words(
                en="shower, shower stall, shower cabin, shower tray",
                fr="douche",
                de="dusche",
                es="ducha",
                zh="淋浴",
                ja="シャワー",
            ),
        ),
        essential=("bath, shower or toilet",),
        forms="shower",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "wall_shower",
        access=FRONT,
        sizes=size_range("20 30 60", "6 12 30", "160 210 240"),
        services=(PIPE,),
        words=(
            words(
                en="wall shower, shower panel, shower column, wet room shower",
                fr="colonne de douche",
                de="duschpaneel, duschsaule",
                es="columna de ducha",
                zh="淋浴柱, 花洒套装",
                ja="シャワーパネル",
            ),
        ),
        essential=("bath, shower or toilet",),
        forms="shower",
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "mirror",
        support="wall",
        back="flat",
        sizes=size_range("25 60 180", "1 3 16", "35 80 190"),
        words=(
            words(en="mirror", fr="miroir", de="spiegel", es="espejo", zh="镜, 鏡", ja="ミラー"),
        ),
        drawn_by=(".furniture.sanitary",),
    ),
    Kind(
        "towel_rail",
        support="wall",
        airy=True,
        sizes=size_range("30 50 80", "4 10 20", "8 80 180"),
        words=(
            words(
                en="towel rail, towel rack, towel bar",
                fr="porte serviettes",
                de="handtuchhalter",
                es="toallero",
                zh="毛巾架",
                ja="タオル掛け",
            ),
        ),
        drawn_by=(".furniture.sanitary",),
    ),
)
