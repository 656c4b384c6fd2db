"""Halls with a stage."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import BOTH, THREE
from scenewright.core.kind import Kind, at_wall, free, size_range, words

KINDS = (
    Kind(
        "auditorium_seat",
        access=BOTH,
        reach=0.45,
        back="high",
        sizes=size_range("45 55 70", "48 62 90", "75 95 120"),
        hall=free("fan chain", 0.45, 0.0, 0.0, 0.0),
        words=(
            words(
                en="auditorium seat, theatre seat, theater seat, cinema seat, theatre chair",
                fr="fauteuil de cinéma, siège d'auditorium, siège de théâtre",
                de="kinosessel, theatersessel, hörsaalsitz",
                es="butaca de cine, butaca de auditorio",
                zh="礼堂椅, 影院座椅, 剧院椅",
                ja="劇場椅子, シアターシート",
            ),
        ),
        drawn_by=(".public.auditorium",),
    ),
    Kind(
        "pew",
        access=BOTH,
        reach=0.35,
        back="high",
        sizes=size_range("120 300 450", "45 55 70", "75 90 110"),
        hall=free("chain", 0.4, 0.6, 0.0, 0.6),
        words=(
            words(
                en="pew, church pew, church bench",
                fr="banc d'église",
                de="kirchenbank",
                es="banco de iglesia",
                zh="教堂长椅",
                ja="教会の長椅子",
            ),
        ),
        drawn_by=(".public.auditorium",),
    ),
    Kind(
        "lectern",
        access=("back",),
        reach=0.6,
        sizes=size_range("40 62 100", "35 55 90", "100 122 145"),
        hall=free("single", 0.3, 0.3, 0.75, 0.3),
        words=(
            words(
                en="lectern, podium, speaker desk, rostrum",
                fr="pupitre, lutrin",
                de="rednerpult, stehpult, lesepult",
                es="atril",
                zh="讲台, 演讲台",
                ja="演台, 講演台",
            ),
        ),
        drawn_by=(".public.auditorium",),
    ),
    Kind(
        "stage",
        access=THREE,
        reach=0.9,
        sizes=size_range("150 600 1200", "120 350 800", "15 50 120"),
        hall=free("single", 1.2, 0.0, 0.0, 0.0),
        words=(
            words(
                en="stage, stage platform",
                fr="estrade, scène de théâtre",
                de="bühne, bühnenpodest",
                es="escenario, tarima",
                zh="舞台",
                ja="ステージ, 舞台",
            ),
        ),
        drawn_by=(".public.auditorium",),
    ),
    Kind(
        "screen",
        label="projection screen",
        sizes=size_range("120 300 900", "3 50 120", "160 260 500"),
        hall=at_wall(0.9, 0.1),
        words=(
            words(
                en="projection screen, projector screen",
                fr="écran de projection",
                de="projektionsleinwand, projektionswand",
                es="pantalla de proyección",
                zh="投影幕, 投影屏",
                ja="プロジェクタースクリーン, 投影スクリーン",
            ),
        ),
        drawn_by=(".public.auditorium",),
    ),
)
