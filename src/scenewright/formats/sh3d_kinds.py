"""Which of our kinds of object a Sweet Home 3D piece is: by catalog id, else by its name."""

from __future__ import annotations

import re
import unicodedata

from scenewright.formats.sh3d_xml import HomePiece

LANDMARKS = frozenset({"staircase", "fireplace", "column"})

CATALOG = {
    "bed140x190": "double_bed", "bed90x190": "single_bed", "bed": "bed",
    "bunkBed90x190": "bunk_bed", "cornerBunkBed90x190": "bunk_bed", "loftBed140x190": "bunk_bed",
    "crib": "cot", "bedsideTable": "nightstand", "chest": "chest_of_drawers",
    "dresser": "chest_of_drawers", "wardrobe": "wardrobe", "slidingDoors": "wardrobe",
    "bookcase": "bookcase", "filledBookcase": "bookcase", "glassDoorCabinet": "display_cabinet",
    "shelves": "wall_shelf", "sofa": "sofa", "sofa2": "sofa", "cornerSofa": "corner_sofa",
    "armchair": "armchair", "armchair2": "armchair", "chair": "dining_chair",
    "chair2": "dining_chair", "stool": "stool", "squareTable": "table", "table": "table",
    "roundTable": "round_table", "coffeeTable": "coffee_table", "desk": "desk",
    "tvUnit": "tv_stand", "flatTV": "tv", "laptop": "laptop", "piano": "piano",
    "aquarium": "box", "fireplace": "fireplace", "toiletUnit": "toilet", "washbasin": "basin",
    "washbasinWithCabinet": "basin", "bath": "bathtub", "fittedBath": "bathtub",
    "shower": "shower", "clothesWasher": "washing_machine", "cooker": "hob_cabinet",
    "dishwasher": "dishwasher", "fridge": "fridge", "fridgeFreezer": "fridge",
    "kitchenCabinet": "base_cabinet", "kitchenUpperCabinet": "wall_cabinet",
    "sink": "sink_cabinet", "hood": "hood", "oven": "oven_cabinet", "plant": "plant",
    "flowers": "vase", "frame": "picture", "curtains": "curtain", "blind": "curtain",
    "mirror": "mirror", "electricRadiator": "radiator", "hotWaterRadiator": "radiator",
    "staircase": "staircase", "curveStaircase": "staircase", "spiralStaircase": "staircase",
    "floorUplight": "floor_lamp", "lamp": "lamp", "workLamp": "desk_lamp",
    "pendantLamp": "pendant_lamp", "spotlight": "ceiling_lamp", "wallUplight": "ceiling_lamp",
    "texturableBox": "", "texturableCylinder": "", "texturableTriangle": "",
}  # fmt: skip

# Read from top to bottom: the first word found in the name decides.
NAMES = (
    ("staircase", "stair escalier treppe 楼梯 樓梯 階段"),
    ("fireplace", "fireplace cheminee kamin chimney 壁炉 壁爐 暖炉"),
    ("column", "column pillar colonne saule pillar 柱"),
    ("radiator", "radiator radiateur heizkorper heater 暖气 散热器 ラジエーター"),
    ("nightstand", "nightstand bedside chevet nachttisch 床头柜 床头桌 床頭櫃 ナイトテーブル"),
    ("bunk_bed", "bunk loft_bed superpose mezzanine hochbett etagenbett 双层床 高低床 二段ベッド"),
    ("cot", "crib cot_ baby_bed berceau lit_bebe babybett kinderbett 婴儿床 ベビーベッド"),
    ("double_bed", "double_bed lit_double doppelbett king_bed queen_bed 双人床 雙人床"),
    ("single_bed", "single_bed lit_simple einzelbett 单人床 單人床 シングルベッド"),
    ("coffee_table", "coffee_table table_basse couchtisch 茶几 ローテーブル コーヒーテーブル"),
    ("side_table", "side_table end_table table_d_appoint beistelltisch 边几 サイドテーブル"),
    ("corner_sofa", "corner_sofa corner_couch canape_d_angle ecksofa 转角沙发 コーナーソファ"),
    ("loveseat", "loveseat two_seater canape_2 zweisitzer 双人沙发"),
    ("sofa", "sofa couch settee canape 沙发 沙發 ソファ"),
    ("armchair", "armchair fauteuil sessel recliner 扶手椅 单人沙发 アームチェア"),
    ("deck_chair", "deck_chair deckchair sun_lounger transat liegestuhl 躺椅 デッキチェア"),
    ("outdoor_table", "garden_table patio_table table_de_jardin gartentisch 户外桌"),
    ("outdoor_chair", "garden_chair patio_chair chaise_de_jardin gartenstuhl 户外椅"),
    ("office_chair", "office_chair desk_chair swivel chaise_de_bureau burostuhl 办公椅"),
    ("bar_stool", "bar_stool barstool tabouret_de_bar barhocker 吧椅 吧凳"),
    ("dining_chair", "chair chaise stuhl 椅 チェア いす"),
    ("stool", "stool tabouret hocker 凳 スツール"),
    ("pouf", "pouf ottoman footstool puff 脚凳 オットマン"),
    ("bench", "bench banc_ banquette sitzbank 长凳 ベンチ"),
    ("console_table", "console konsolentisch 玄关桌 コンソール"),
    ("round_table", "round_table table_ronde runder_tisch 圆桌 圓桌 丸テーブル"),
    ("tv_stand", "tv_unit tv_stand tv_cabinet meuble_tv tv_mobel 电视柜 電視櫃 テレビ台"),
    ("tv", "tv_ television fernseher 电视 電視 テレビ"),
    ("laptop", "laptop notebook ordinateur_portable 笔记本 ノートパソコン"),
    ("monitor", "monitor computer screen ordinateur bildschirm 显示器 电脑 モニター"),
    ("desk", "desk bureau schreibtisch 书桌 書桌 写字台 デスク"),
    ("dining_table", "dining_table table_a_manger esstisch 餐桌 ダイニングテーブル"),
    ("hob_cabinet", "cooker stove hob cooktop range cuisiniere plaque herd 炉灶 灶 灶具 コンロ"),
    ("hood", "hood hotte dunstabzug 抽油烟机 油烟机 レンジフード"),
    ("oven_cabinet", "oven microwave four_ ofen 烤箱 微波炉 オーブン"),
    ("fridge", "fridge freezer refrigerator refrigerateur frigo kuhlschrank 冰箱 冷蔵庫"),
    ("dishwasher", "dishwasher lave_vaisselle spulmaschine geschirrspuler 洗碗机 食洗機"),
    ("washing_machine", "washer washing_machine lave_linge waschmaschine 洗衣机 洗衣機 洗濯機"),
    ("dryer", "tumble_dryer dryer seche_linge trockner 烘干机 乾燥機"),
    ("basin", "washbasin_with_cabinet vanity meuble_vasque waschtisch 浴室柜 洗面台"),
    ("basin", "washbasin basin lavabo waschbecken 洗手盆 面盆 洗脸盆 洗面器"),
    ("sink_cabinet", "sink evier spule 水槽 シンク"),
    ("toilet", "toilet wc_ cuvette 马桶 坐便器 便器"),
    ("bathtub", "bathtub bath_tub bath_ baignoire badewanne 浴缸 バスタブ 浴槽"),
    ("shower", "shower douche dusche 淋浴 シャワー"),
    ("wall_cabinet", "upper_cabinet wall_cabinet meuble_haut hangeschrank oberschrank 吊柜 吊戸棚"),
    ("base_cabinet", "kitchen_cabinet base_cabinet worktop counter meuble_bas unterschrank 橱柜"),
    ("display_cabinet", "glass_door_cabinet display vitrine 玻璃柜 ガラス"),
    ("shoe_cabinet", "shoe chaussure schuhschrank 鞋柜 鞋櫃 下駄箱 シューズ"),
    ("bookcase", "bookcase bookshelf bibliotheque bucherregal 书架 書架 书柜 本棚"),
    ("wardrobe", "wardrobe armoire penderie kleiderschrank closet 衣柜 衣櫃 ワードローブ たんす"),
    ("chest_of_drawers", "chest_of_drawers chest dresser commode kommode 斗柜 五斗柜 チェスト"),
    ("sideboard", "sideboard buffet bahut anrichte credenza 餐边柜 サイドボード"),
    ("wall_shelf", "wall_shelf etagere_murale wandregal 壁架 ウォールシェルフ"),
    ("shelf_unit", "shelf shelves shelving etagere regal 架子 置物架 シェルフ 棚"),
    ("coat_rack", "coat_rack porte_manteau garderobenstander 衣帽架 コートハンガー"),
    ("table_lamp", "table_lamp bedside_lamp lampe_de_chevet tischlampe 台灯 テーブルランプ"),
    ("floor_lamp", "floor_lamp floor_uplight lampadaire stehlampe 落地灯 フロアランプ"),
    ("pendant_lamp", "pendant chandelier suspension hangelampe 吊灯 ペンダント"),
    ("ceiling_lamp", "ceiling_light ceiling_lamp spotlight uplight plafonnier 吸顶灯 シーリング"),
    ("lamp", "lamp light lampe leuchte 灯 燈 ランプ ライト"),
    ("rug", "rug carpet tapis teppich 地毯 ラグ カーペット"),
    ("curtain", "curtain blind rideau store_ vorhang gardine 窗帘 窗簾 カーテン"),
    ("mirror", "mirror miroir spiegel 镜 鏡 ミラー"),
    ("wall_clock", "clock horloge uhr_ 钟 時計"),
    ("picture", "picture painting frame poster tableau cadre bild 画 相框 絵"),
    ("vase", "vase flowers fleurs blumen 花瓶 花"),
    ("potted_tree", "tree arbre baum_ ficus palm 树 樹"),
    ("plant", "plant plante pflanze 植物 盆栽 観葉"),
    ("books", "books livres bucher 书籍 本_"),
    ("piano", "piano klavier flugel 钢琴 鋼琴 ピアノ"),
    ("exercise_bike", "exercise_bike treadmill velo heimtrainer 健身车"),
    ("ironing_board", "ironing repasser bugelbrett 熨衣板 アイロン台"),
    ("speaker", "speaker enceinte lautsprecher 音箱 スピーカー"),
    ("bed", "bed lit_ bett 床 ベッド"),
    ("table", "table tisch 桌 テーブル"),
    ("wardrobe", "cabinet cupboard placard schrank 柜 櫃"),
    ("box", "box cube boite kiste 箱"),
)  # fmt: skip


def kind_of(piece: HomePiece) -> str:
    """The category of a piece, ``obstacle`` if neither its catalog id nor its name says.

    Beds, tables, sofas and lamps are told apart by size.
    """
    kind = CATALOG.get(piece.catalog) or _by_name(piece.name)
    by_size = {
        "bed": "double_bed" if piece.width >= 1.2 else "single_bed",
        "table": "coffee_table" if piece.height < 0.55 else "dining_table",
        "sofa": "loveseat" if piece.width < 1.75 else "sofa",
        "lamp": "floor_lamp" if piece.height > 1.1 else "table_lamp",
    }
    return by_size.get(kind, kind)


def _by_name(name: str) -> str:
    words = f"_{_plain(name)}_"
    found = (k for k, names in NAMES for word in names.split() if _holds(words, word))
    return next(found, "obstacle")


def _holds(words: str, word: str) -> bool:
    """Latin words match from the start of a word; with a final ``_`` to its end as well."""
    return f"_{word}" in words if word.isascii() else word.rstrip("_") in words


def _plain(name: str) -> str:
    text = unicodedata.normalize("NFKC", name).casefold()
    text = "".join(
        unicodedata.normalize("NFD", sign)[0] if ord(sign) < 0x250 else sign for sign in text
    )
    return re.sub(r"[\W\d_]+", "_", text).strip("_")
