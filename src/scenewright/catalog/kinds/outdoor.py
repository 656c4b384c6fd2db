"""Balconies and terraces."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, FRONT, THREE
from scenewright.core.kind import Kind, free, size_range, words

KINDS = (
    Kind(
        "outdoor_table",
        access=ALL_SIDES,
        airy=True,
        sizes=size_range("40 80 220", "40 80 110", "40 72 78"),
        hall=free("grid chain", 0.75),
        words=(
            words(
                en="garden table, patio table, cafe table, outdoor table, picnic table",
                fr="table de jardin",
                de="gartentisch",
                es="mesa de jardin",
                zh="户外桌",
                ja="ガーデンテーブル",
            ),
        ),
        forms="terrace",
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "outdoor_chair",
        access=THREE,
        under=("outdoor_table",),
        airy=True,
        back="high",
        sizes=size_range("44 54 70", "44 56 75", "70 82 98"),
        words=(
            words(
                en="garden chair, patio chair, cafe chair, outdoor chair",
                fr="chaise de jardin",
                de="gartenstuhl",
                es="silla de jardin",
                zh="户外椅",
                ja="ガーデンチェア",
            ),
        ),
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "deck_chair",
        access=FRONT,
        airy=True,
        back="high",
        sizes=size_range("55 66 85", "120 190 215", "30 75 112"),
        words=(
            words(
                en=(
                    "deck chair, deckchair, sun lounger, pool lounge, chaise longue, relax "
                    "chair, lounge chair relax"
                ),
                fr="transat, chaise longue",
                de="liegestuhl, sonnenliege",
                es="tumbona",
                zh="躺椅, 折叠躺椅",
                ja="デッキチェア",
            ),
        ),
        forms="lounger",
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "planter",
        airy=True,
        sizes=size_range("25 80 200", "18 30 60", "30 60 150"),
        hall=free("grid chain single", 0.15),
        words=(
            words(
                en="planter, flower box, plant box, window box",
                fr="jardiniere",
                de="blumenkasten, pflanzkubel",
                es="jardinera",
                zh="花箱",
                ja="プランター",
            ),
        ),
        drawn_by=(".furniture.outdoor",),
    ),
    Kind(
        "drying_rack",
        access=ALL_SIDES,
        airy=True,
        sizes=size_range("50 100 190", "35 55 70", "75 95 120"),
        words=(
            words(
                en="drying rack, clothes horse",
                fr="etendoir",
                de="waschestander",
                es="tendedero",
                zh="晾衣架",
                ja="物干し",
            ),
        ),
        drawn_by=(".furniture.outdoor",),
    ),
)
