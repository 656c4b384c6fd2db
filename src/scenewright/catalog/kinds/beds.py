"""Beds and nightstands."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import FLANKS, THREE
from scenewright.core.kind import Kind, OwnGroup, size_range, words

KINDS = (
    Kind(
        "double_bed",
        access=FLANKS,
        back="high",
        sizes=size_range("135 160 215", "190 205 235", "70 95 130"),
        words=(
            words(
                en="double bed, king bed, queen bed",
                fr="lit double",
                de="doppelbett",
                es="cama doble, cama de matrimonio",
                zh="双人床, 雙人床",
                ja="ダブルベッド",
            ),
            words("single_bed", en="bed", fr="lit", de="bett", es="cama", zh="床", ja="ベッド"),
        ),
        essential=("bed", "double bed"),
        forms="sleeping",
        drawn_by=(".furniture.beds", ".styled.beds"),
    ),
    Kind(
        "single_bed",
        access=THREE,
        back="high",
        sizes=size_range("70 90 130", "160 205 220", "55 95 120"),
        words=(
            words(
                en="single bed, child bed, day bed, captain s bed",
                fr="lit simple",
                de="einzelbett",
                es="cama individual",
                zh="单人床, 單人床",
                ja="シングルベッド",
            ),
        ),
        essential=("bed",),
        forms="single",
        drawn_by=(".furniture.beds", ".styled.beds"),
    ),
    Kind(
        "bunk_bed",
        access=THREE,
        sizes=size_range("80 100 120", "165 205 220", "145 165 185"),
        words=(
            words(
                en="bunk, bunk bed, loft bed, mezzanine bed",
                fr="superpose, mezzanine",
                de="hochbett, etagenbett",
                es="litera",
                zh="双层床, 高低床",
                ja="二段ベッド",
            ),
        ),
        essential=("bed",),
        forms="bunk",
        drawn_by=(".furniture.beds",),
    ),
    Kind(
        "cot",
        access=THREE,
        sizes=size_range("60 68 80", "110 126 150", "75 90 110"),
        words=(
            words(
                en="crib, cot, baby bed, rocking bed",
                fr="berceau, lit bebe",
                de="babybett, kinderbett, wiege",
                es="cuna",
                zh="婴儿床",
                ja="ベビーベッド",
            ),
        ),
        essential=("bed",),
        alone=OwnGroup("cot"),
        drawn_by=(".furniture.beds",),
    ),
    Kind(
        "nightstand",
        back="flat",
        sizes=size_range("28 42 65", "28 40 52", "38 50 65"),
        words=(
            words(
                en=(
                    "nightstand, night stand, night table, bedside table, bedside cabinet, bed "
                    "cabinet, bed cabinet drawer, bed drawer cabinet"
                ),
                fr="chevet, table de chevet",
                de="nachttisch, nachtkastchen",
                es="mesilla, mesita de noche",
                zh="床头柜, 床头桌, 床頭櫃",
                ja="ナイトテーブル",
            ),
        ),
        essential=("nightstand",),
        drawn_by=(".furniture.beds", ".styled.cases"),
    ),
)
