"""Kitchen units and appliances."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, FRONT, HOSE, LEAD, PIPE
from scenewright.core.kind import Kind, size_range, words

KINDS = (
    Kind(
        "sink_cabinet",
        access=FRONT,
        reach=0.9,
        sizes=size_range("40 80 125", "50 60 66", "80 90 125"),
        services=(PIPE,),
        words=(
            words(
                en="sink, kitchen sink, sink cabinet, sink unit",
                fr="evier",
                de="spule",
                es="fregadero",
                zh="水槽",
                ja="シンク",
            ),
        ),
        in_rooms=(("bathroom", ("basin", "pedestal_basin")),),
        essential=("sink", "base units"),
        forms="kitchen",
        drawn_by=(".furniture.cooking", ".styled.kitchens"),
    ),
    Kind(
        "drawer_cabinet",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("25 60 125", "50 60 66", "80 90 96"),
        words=(
            words(
                en="drawers cabinet, drawer cabinet, kitchen drawers, kitchen drawer cabinet",
                fr="meuble a tiroirs bas",
                de="schubladenschrank, schubladenunterschrank",
                es="mueble cajonero",
                zh="抽屉橱柜",
                ja="引き出しキャビネット",
            ),
        ),
        essential=("base units",),
        forms="counter",
        drawn_by=(".furniture.kitchen", ".styled.kitchens"),
    ),
    Kind(
        "base_cabinet",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("15 60 125", "50 60 66", "80 90 96"),
        words=(
            words(
                en="kitchen cabinet, base cabinet, lower cabinet, worktop, counter",
                fr="meuble bas",
                de="unterschrank",
                es="mueble bajo",
                zh="橱柜",
                ja="キッチンキャビネット",
            ),
        ),
        essential=("base units",),
        forms="counter",
        drawn_by=(".furniture.kitchen", ".styled.kitchens"),
    ),
    Kind(
        "filler_panel",
        back="flat",
        label="filler strip",
        sizes=size_range("1 10 30", "50 60 66", "80 90 96"),
        words=(
            words(
                en="filler strip, filler panel",
                fr="fileur",
                de="passleiste, blende",
                es="regleta",
                zh="封板",
                ja="フィラー",
            ),
        ),
        drawn_by=(".furniture.kitchen",),
    ),
    Kind(
        "tall_cabinet",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("25 60 125", "35 60 66", "160 215 240"),
        words=(
            words(
                en="high cabinet, tall cabinet, pantry cabinet",
                fr="colonne de cuisine",
                de="hochschrank",
                es="mueble columna",
                zh="高柜",
                ja="トールキャビネット, パントリー収納",
            ),
        ),
        essential=("storage",),
        drawn_by=(".furniture.kitchen", ".styled.kitchens"),
    ),
    Kind(
        "wall_cabinet",
        support="wall",
        back="flat",
        sizes=size_range("15 60 125", "25 35 42", "30 70 100"),
        words=(
            words(
                en=(
                    "upper cabinet, wall cabinet, overhead cabinet, kitchen upper cabinet, upper "
                    "kitchen cabinet"
                ),
                fr="meuble haut",
                de="hangeschrank, oberschrank",
                es="armario alto, mueble alto",
                zh="吊柜",
                ja="吊戸棚",
            ),
        ),
        drawn_by=(".furniture.kitchen", ".styled.kitchens"),
    ),
    Kind(
        "hood",
        support="wall",
        back="flat",
        sizes=size_range("28 60 125", "28 48 56", "12 65 110"),
        words=(
            words(
                en="hood, range hood, cooker hood, extractor hood",
                fr="hotte",
                de="dunstabzug, dunstabzugshaube",
                es="campana extractora",
                zh="抽油烟机, 油烟机",
                ja="レンジフード",
            ),
        ),
        drawn_by=(".furniture.kitchen",),
    ),
    Kind(
        "kitchen_island",
        access=ALL_SIDES,
        reach=0.9,
        sizes=size_range("90 160 300", "60 85 125", "85 92 100"),
        words=(
            words(
                en="kitchen island, island",
                fr="ilot",
                de="kochinsel",
                es="isla de cocina",
                zh="中岛",
                ja="アイランドキッチン",
            ),
        ),
        drawn_by=(".furniture.kitchen", ".styled.kitchens"),
    ),
    Kind(
        "corner_cabinet",  # opens inwards, to who stands before the units beside it
        reach=0.9,
        sizes=size_range("78 90 110", "78 90 110", "80 90 96"),
        words=(
            words(
                en="corner cabinet, lower corner cabinet, kitchen corner cabinet",
                fr="meuble d angle",
                de="eckunterschrank",
                es="mueble rinconero",
                zh="转角橱柜",
                ja="コーナーキャビネット",
            ),
        ),
        drawn_by=(".furniture.kitchen", ".styled.kitchens"),
    ),
    Kind(
        "hob_cabinet",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("28 60 95", "50 60 66", "80 90 96"),
        services=(LEAD,),
        words=(
            words(
                en="cooker, stove, hob, cooktop, range, kitchen stove",
                fr="cuisiniere, plaque de cuisson",
                de="herd, kochfeld",
                es="cocina de gas, placa de cocina, fogones",
                zh="炉灶, 灶, 灶具",
                ja="コンロ",
            ),
        ),
        essential=("hob", "base units"),
        drawn_by=(".furniture.cooking", ".styled.kitchens"),
    ),
    Kind(
        "oven_cabinet",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("45 60 95", "50 60 66", "80 90 96"),
        services=(LEAD,),
        words=(
            words(
                en="oven, double oven",
                fr="four",
                de="ofen, backofen",
                es="horno",
                zh="烤箱",
                ja="オーブン",
            ),
        ),
        drawn_by=(".furniture.cooking", ".styled.kitchens"),
    ),
    Kind(
        "dishwasher",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("44 60 65", "50 60 66", "80 90 96"),
        services=(LEAD, HOSE),
        words=(
            words(
                en="dishwasher, dish washer",
                fr="lave vaisselle",
                de="spulmaschine, geschirrspuler",
                es="lavavajillas",
                zh="洗碗机",
                ja="食洗機",
            ),
        ),
        essential=("base units",),
        drawn_by=(".furniture.cooking",),
    ),
    Kind(
        "fridge",
        access=FRONT,
        reach=0.9,
        back="flat",
        sizes=size_range("48 60 100", "52 65 85", "80 185 215"),
        services=(LEAD,),
        words=(
            words(
                en="fridge, freezer, refrigerator, fridge freezer",
                fr="refrigerateur, frigo, congelateur",
                de="kuhlschrank",
                es="frigorifico, nevera",
                zh="冰箱",
                ja="冷蔵庫",
            ),
        ),
        essential=("fridge",),
        forms="fridge",
        drawn_by=(".furniture.cooking",),
    ),
)
