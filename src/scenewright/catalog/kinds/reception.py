"""Desks, barriers and machines of public buildings."""

from __future__ import annotations

from scenewright.catalog.kinds.usual import ALL_SIDES, BOTH, FRONT
from scenewright.core.kind import Kind, at_wall, free, size_range, words

KINDS = (
    Kind(
        "counter",
        access=FRONT,
        reach=0.9,
        sizes=size_range("80 200 800", "45 65 120", "80 100 120"),
        hall=free("chain single", 0.9, 0.0, 0.9, 0.0),
        staff=0.9,
        words=(
            words(
                en="shop counter, sales counter, service counter, bar counter, bank counter",
                fr="comptoir, comptoir de vente",
                de="theke, verkaufstheke, ladentheke, tresen",
                es="mostrador",
                zh="柜台, 服务台",
                ja="受付台, 販売カウンター",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "info_desk",
        access=FRONT,
        reach=0.9,
        sizes=size_range("120 260 800", "60 90 250", "90 110 125"),
        hall=free("single", 1.2, 0.3, 0.9, 0.3),
        staff=0.9,
        words=(
            words(
                en="information desk, info desk, reception desk, reception counter, help desk",
                fr="banque d'accueil, bureau d'accueil",
                de="empfangstheke, infotheke, empfangstresen",
                es="mostrador de recepción, mostrador de información",
                zh="前台, 接待台, 问讯台",
                ja="受付カウンター, インフォメーションデスク",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "corner_counter",
        access=FRONT,
        reach=0.9,
        sizes=size_range("160 280 600", "140 220 400", "90 110 120"),
        hall=free("single", 1.2, 0.3, 0.3, 0.3),
        words=(
            words(
                en="corner counter, l shaped counter, l shaped reception, corner reception desk",
                fr="comptoir d'angle, banque d'accueil d'angle",
                de="ecktheke, winkeltheke, ecktresen",
                es="mostrador esquinero, mostrador en l",
                zh="转角柜台, 转角前台",
                ja="コーナーカウンター, L字カウンター",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "ticket_gate",
        access=BOTH,
        reach=0.9,
        sizes=size_range("70 95 130", "80 140 200", "90 100 120"),
        hall=free("chain", 1.2, 0.0, 1.2, 0.0),
        words=(
            words(
                en="ticket gate, turnstile, speed gate, access gate",
                fr="tourniquet, portillon d'accès",
                de="drehkreuz, drehsperre",
                es="torniquete",
                zh="检票闸机, 闸机",
                ja="改札機, 自動改札",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "rope_barrier",
        sizes=size_range("80 150 300", "25 32 45", "85 98 110"),
        hall=free("chain", 0.3, 0.0, 0.3, 0.0),
        words=(
            words(
                en="rope barrier, stanchion, queue barrier, belt barrier",
                fr="barrière à corde, poteau de guidage",
                de="absperrpfosten, absperrkordel",
                es="poste separador, catenaria",
                zh="围栏绳, 隔离栏",
                ja="ロープパーテーション, ベルトパーテーション",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "partition",
        sizes=size_range("30 200 3000", "10 15 25", "200 300 600"),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "glass_barrier",
        sizes=size_range("20 200 3000", "5 6 12", "80 100 130"),
        words=(
            words(
                en="glass barrier, glass balustrade, glass railing",
                fr="garde-corps en verre, barrière en verre",
                de="glasbrüstung, glasabsperrung, glasgeländer",
                es="barandilla de vidrio, barrera de vidrio",
                zh="玻璃栏板, 玻璃护栏",
                ja="ガラス柵, ガラス手摺",
            ),
        ),
        drawn_by=(".public.barriers",),
    ),
    Kind(
        "gate_leaf",
        swings=True,
        sizes=size_range("40 110 260", "2 3 5", "60 90 120"),
        words=(
            words(
                en="gate leaf, gate wing",
                fr="vantail de portillon",
                de="schwenkflügel, torflügel",
                es="hoja de portillo",
                zh="闸机门翼",
                ja="改札扉",
            ),
        ),
        drawn_by=(".public.barriers",),
    ),
    Kind(
        "gate_post",
        sizes=size_range("60 120 220", "15 20 30", "80 100 130"),
        words=(
            words(
                en="gate post, gate housing",
                fr="montant de portillon",
                de="torpfosten, schleusenpfosten",
                es="pilar de torniquete",
                zh="闸机立柱",
                ja="改札柱",
            ),
        ),
        drawn_by=(".public.barriers",),
    ),
    Kind(
        "litter_bin",
        access=ALL_SIDES,
        reach=0.45,
        sizes=size_range("25 40 120", "25 40 60", "45 80 130"),
        hall=at_wall(0.45, 0.15),
        words=(
            words(
                en="dustbin, trash can, trashcan, waste basket, litter bin, garbage can",
                fr="poubelle, corbeille",
                de="mulleimer, papierkorb",
                es="papelera",
                zh="垃圾箱, 垃圾桶",
                ja="ごみ箱",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "sign_totem",
        sizes=size_range("30 60 120", "10 25 60", "120 200 300"),
        hall=free("single", 0.45, 0.15, 0.15, 0.15),
        words=(
            words(
                en="sign totem, totem sign, information totem, wayfinding totem",
                fr="totem signalétique, totem d'information",
                de="infostele, wegweiserstele",
                es="tótem informativo, tótem señalético",
                zh="导视牌, 立式指示牌",
                ja="サインポール, 案内サイン",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "lockers",
        access=FRONT,
        reach=0.75,
        sizes=size_range("28 120 400", "30 50 65", "90 185 220"),
        hall=at_wall(0.9),
        words=(
            words(
                en="locker, lockers, locker bank",
                fr="casier de vestiaire, vestiaire à casiers",
                de="schließfach, spind, schließfachschrank",
                es="taquilla, taquillas",
                zh="储物柜, 寄存柜",
                ja="ロッカー, コインロッカー",
            ),
        ),
        drawn_by=(".public.reception",),
    ),
    Kind(
        "vending_machine",
        access=FRONT,
        reach=0.75,
        sizes=size_range("60 95 140", "60 85 110", "150 185 210"),
        hall=at_wall(0.9),
        words=(
            words(
                en="vending machine, drinks machine, snack machine",
                fr="distributeur automatique",
                de="verkaufsautomat, getränkeautomat",
                es="máquina expendedora",
                zh="自动售货机, 售货机",
                ja="自動販売機, 自販機",
            ),
        ),
        drawn_by=(".public.reception", ".public.machines"),
    ),
    Kind(
        "cash_machine",
        access=FRONT,
        reach=0.75,
        sizes=size_range("55 75 120", "50 75 110", "130 155 210"),
        hall=at_wall(0.9),
        words=(
            words(
                en="cash machine, cash dispenser, atm, teller machine",
                fr="distributeur de billets",
                de="geldautomat, bankomat",
                es="cajero automático",
                zh="取款机, 自动取款机",
                ja="現金自動預払機",
            ),
        ),
        drawn_by=(".public.machines",),
    ),
    Kind(
        "ticket_machine",
        access=FRONT,
        reach=0.75,
        sizes=size_range("55 80 120", "50 75 110", "130 175 210"),
        hall=at_wall(0.9),
        words=(
            words(
                en="ticket machine, ticket vending machine, fare machine",
                fr="distributeur de titres de transport",
                de="fahrkartenautomat, fahrscheinautomat, ticketautomat",
                es="máquina de billetes",
                zh="售票机, 自动售票机",
                ja="券売機",
            ),
        ),
        drawn_by=(".public.machines",),
    ),
    Kind(
        "copier",
        access=FRONT,
        reach=0.75,
        sizes=size_range("50 70 140", "50 70 85", "95 110 130"),
        hall=at_wall(0.9),
        words=(
            words(
                en="copier, photocopier, copy machine, printer, laser printer",
                fr="photocopieur, photocopieuse, imprimante",
                de="kopierer, kopiergerät, fotokopierer, drucker, laserdrucker",
                es="fotocopiadora, impresora",
                zh="复印机, 打印机",
                ja="コピー機, 複合機, プリンター",
            ),
        ),
        drawn_by=(".public.machines",),
    ),
)
