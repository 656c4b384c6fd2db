"""Machines for laundry, sound and pictures."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FRONT, HOSE, LEAD
from scenewright.core.kind import Kind, Service, size_range, words

KINDS = (
    Kind(
        "washing_machine",
        access=FRONT,
        reach=0.6,
        back="flat",
        sizes=size_range("44 60 70", "38 60 70", "78 85 106"),
        services=(LEAD, HOSE),
        words=(
            words(
                en="washer, washing machine, clothes washer",
                fr="lave linge, machine a laver",
                de="waschmaschine",
                es="lavadora",
                zh="洗衣机, 洗衣機",
                ja="洗濯機",
            ),
        ),
        essential=("basin or washing machine",),
        forms="washer",
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "dryer",
        access=FRONT,
        reach=0.6,
        back="flat",
        sizes=size_range("55 60 70", "50 60 70", "80 85 106"),
        services=(LEAD,),
        words=(
            words(
                en="tumble dryer, dryer, clothes dryer",
                fr="seche linge",
                de="trockner, waschetrockner",
                es="secadora",
                zh="烘干机",
                ja="乾燥機",
            ),
        ),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "tv",
        label="television",
        support="top",
        sizes=size_range("50 110 190", "4 20 35", "32 68 115"),
        services=(LEAD, Service("antenna", 1.5, "cable")),
        words=(
            words(
                en="tv, television, television screen",
                fr="televiseur, television",
                de="fernseher",
                es="televisor, television",
                zh="电视, 電視",
                ja="テレビ",
            ),
        ),
        essential=("screen or focal point",),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "monitor",
        support="top",
        sizes=size_range("36 58 90", "12 20 28", "34 45 60"),
        words=(
            words(
                en="monitor, computer screen, computer monitor, desktop computer",
                fr="ecran",
                de="bildschirm",
                es="pantalla",
                zh="显示器, 电脑",
                ja="モニター",
            ),
        ),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "laptop",
        support="top",
        back="high",
        sizes=size_range("26 34 42", "18 25 30", "16 22 28"),
        words=(
            words(
                en="laptop, notebook, laptop computer, i book, mac book",
                fr="ordinateur portable",
                de="notebook",
                es="ordenador portatil",
                zh="笔记本",
                ja="ノートパソコン",
            ),
        ),
        drawn_by=(".furniture.appliances",),
    ),
    Kind(
        "speaker",
        sizes=size_range("12 24 40", "14 28 42", "20 90 120"),
        words=(
            words(
                en="speaker, loudspeaker",
                fr="enceinte",
                de="lautsprecher",
                es="altavoz",
                zh="音箱",
                ja="スピーカー",
            ),
        ),
        drawn_by=(".furniture.appliances",),
    ),
)
