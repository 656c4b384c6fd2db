"""What a room is for, read from its name in English, French, German, Chinese or Japanese.

A name may hold several functions ("Wohn-/Esszimmer", "LDK", "客餐厅"). Case, accents, numbers,
plurals and a slip of the pen in a long word do not matter.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable
from functools import cache
from typing import NamedTuple

from scenewright.text import fold_letters

OPEN_PLAN = frozenset({"living", "dining", "kitchen"})

# Phrases in plain letters. English, German, Chinese and Japanese name the thing last
# ("bedroom closet"), French first ("placard chambre").
LAST = {
    "living": "living; living room; livingroom; lounge; sitting room; family room; great room;"
    "drawing room; parlour; parlor; tv room; media room; sunroom; sun room; wohnzimmer; stube;"
    "wohnraum; wohnbereich; wohn; wohnen; kaminzimmer; l",
    "dining": "dining; dining room; diningroom; dinette; breakfast nook; breakfast room;"
    "esszimmer; essbereich; essplatz; essecke; ess; essen; speisezimmer",
    "kitchen": "kitchen; kitchenette; kuche; kueche; kochnische; koch; kochen; pantry kitchen; k",
    "living kitchen": "wohnkuche; wohnkueche; lk",
    "dining kitchen": "esskuche; esskueche; eat in kitchen; dk; kitchen diner; diner kitchen",
    "living dining": "lounge diner; living diner; ld",
    "living dining kitchen": "ldk; wohnesskuche; wohnesskueche",
    "bedroom": "bedroom; bed room; bed; guest room; guestroom; guest; schlafzimmer; gastezimmer;"
    "gaestezimmer; zimmer; schlafraum; schlafen; gast; gaste; br",
    "double_bedroom": "master bedroom; main bedroom; primary bedroom; parents bedroom; master;"
    "parent bedroom; double bedroom; principal bedroom; elternzimmer; elternschlafzimmer; eltern;"
    "doppelzimmer; hauptschlafzimmer; parents; parents room; master suite; primary suite; mbr",
    "single_bedroom": "single bedroom; single room; maid room; maids room; einzelzimmer;"
    "staff bedroom",
    "child_bedroom": "child; kid; children; kids; baby; child bedroom; children bedroom;"
    "childrens bedroom; childs bedroom; kids bedroom; kid bedroom; kids room; kid room;"
    "child room; childs room; children room;"
    "childrens room; boys room; girls room; boy room; girl room; nursery; playroom; play room;"
    "baby room; babys room; kinderzimmer; babyzimmer; kind; kinder; spielzimmer; jugendzimmer",
    "study": "study; office; home office; den; library; work room; workroom; workspace; computer;"
    "arbeitszimmer; buro; buero; arbeiten; homeoffice; bibliothek; atelier; studierzimmer",
    "bathroom": "bath; bathroom; bath room; shower; shower room; master bath; ensuite; en suite;"
    "wet room; bad; badezimmer; dusche; duschbad; gastebad; gaestebad; hauptbad; elternbad;"
    "kinderbad; duschraum; ub; restroom with shower",
    "toilet": "toilet; wc; w c; lavatory; loo; powder room; restroom; rest room; half bath;"
    "cloakroom; toilette; gastewc; gaestewc; gaste wc; gaeste wc; klo; guest wc; guest toilet",
    "washroom": "laundry; laundry room; utility; utility room; washroom; wash room; washing room;"
    "waschkuche; waschkueche; waschraum; hauswirtschaftsraum; hwr; mud room; mudroom",
    "hall": "hall; hallway; corridor; entry; entrance; entrance hall; entryway; foyer; lobby;"
    "passage; passageway; landing; vestibule; porch; staircase; stairs; stairwell; stairway; flur;"
    "diele; gang; eingang; eingangsbereich; korridor; vorraum; vorzimmer; windfang; garderobe;"
    "treppe; treppenhaus; stairs hall; eingangshalle; halle",
    "storage": "storage; storage room; store; store room; storeroom; closet; walk in closet;"
    "walk in; wardrobe; wardrobe room; dressing; dressing room; pantry; larder; box room; cellar;"
    "linen; abstellraum; abstellkammer; abstell; kammer; speisekammer; vorratsraum; vorrat;"
    "ankleide; ankleidezimmer; lager; keller; kellerraum; speis; wic; sic; cl; schrankraum",
    "balcony": "balcony; terrace; patio; loggia; deck; veranda; verandah; balkon; terrasse;"
    "dachterrasse; roof terrace; wintergarten; outdoor",
    "other": "garage; carport; attic; basement; gym; boiler room; technical room; plant room;"
    "technikraum; heizungsraum; hobbyraum; dachboden; speicher; elevator; lift; shaft; schacht;"
    "aufzug; bar; sauna; pool; garten; garden; yard; void; luftraum",
}
FIRST = {
    "living": "salon; sejour; salle de sejour; piece a vivre; piece de vie; salle de vie",
    "dining": "salle a manger; coin repas; coin repas salle",
    "living dining": "salon sejour; sejour double",
    "kitchen": "cuisine; coin cuisine; kitchenette; cuisinette",
    "bedroom": "chambre; chambre a coucher; chambre d ami; chambre d amis; chb; ch",
    "double_bedroom": "chambre parentale; chambre des parents; chambre parents; suite parentale;"
    "chambre principale; chambre double; chambre maitre",
    "child_bedroom": "chambre enfant; chambre d enfant; chambre des enfants; chambre bebe;"
    "chambre de bebe; chambre fille; chambre garcon; salle de jeux; chambre de fille;"
    "chambre de garcon; chambre ado",
    "single_bedroom": "chambre simple; chambre de bonne",
    "study": "bureau; bibliotheque; cabinet de travail; espace bureau",
    "bathroom": "salle de bain; sdb; salle d eau; sde; s d b; douche; bain; bains",
    "toilet": "toilettes; cabinet de toilette; wc; cabinet",
    "washroom": "buanderie; lingerie",
    "hall": "entree; couloir; degagement; hall d entree; palier; vestibule; escalier; sas;"
    "galerie; montee; circulation",
    "storage": "cellier; placard; debarras; rangement; cave; dressing; garde manger; reserve;"
    "local; remise; penderie; reduit",
    "balcony": "balcon; terrasse; veranda; loggia",
    "other": "grenier; comble; garage; chaufferie; sous sol; jardin; vide; vide sur sejour",
}
SIGNS = {
    "living": "客厅 客廳 客聽 起居室 起居厅 起居廳 会客厅 會客廳 家庭厅 家庭廳 居间 居間 リビング",
    "dining": "餐厅 餐廳 饭厅 飯廳 食堂 ダイニング 餐区",
    "kitchen": "厨房 廚房 厨 廚 台所 キッチン",
    "living dining": "客餐厅 客餐廳 餐客厅 餐客廳 客饭厅 客飯廳 客厅餐厅",
    "dining kitchen": "餐厨 餐廚 ダイニングキッチン",
    "bedroom": "卧室 臥室 卧房 臥房 次卧 次臥 侧卧 客卧 客臥 睡房 寝室 洋室 和室 客房 客人房 老人房"
    " 长辈房 長輩房 父母房 卧 臥 ベッドルーム 客間 房间 房間",
    "double_bedroom": "主卧 主臥 主卧室 主臥室 主人房 主睡房 主寝室 夫妻房 夫婦寝室 双人房 雙人房"
    " 主卧房 主人卧室",
    "single_bedroom": "单人房 單人房 保姆房 保姆间 佣人房 傭人房 工人房",
    "child_bedroom": "儿童房 兒童房 儿童卧室 小孩房 孩子房 女儿房 女兒房 儿子房 男孩房 女孩房"
    " 婴儿房 嬰兒房 宝宝房 游戏室 子供部屋 子ども部屋 こども部屋 キッズルーム 儿童间",
    "study": "书房 書房 工作室 工作间 办公室 辦公室 办公 書斎 ワークスペース ワークルーム 仕事部屋",
    "bathroom": "卫生间 衛生間 浴室 主卫 主衛 次卫 次衛 公卫 公衛 客卫 客衛 内卫 外卫 卫浴 衛浴 卫"
    " 洗澡间 淋浴间 バスルーム 浴厕 風呂 ユニットバス バス シャワー",
    "toilet": "厕所 廁所 洗手间 洗手間 厕 トイレ 便所 化粧室 お手洗",
    "washroom": "洗衣房 洗衣间 洗衣間 洗衣室 洗面室 洗面所 洗面 脱衣室 洗面脱衣室 盥洗室 盥洗间"
    " 家务间 家事室 家政间 ランドリー ユーティリティ",
    "hall": "玄关 玄關 走廊 过道 過道 门厅 門廳 走道 入口 玄関 廊下 ホール 楼梯 樓梯 楼梯间 樓梯間"
    " 階段 过厅 エントランス",
    "storage": "储藏室 儲藏室 储藏间 储物间 儲物間 储物室 儲物室 储藏 衣帽间 衣帽間 更衣室 更衣间"
    " 贮藏室 杂物间 雜物間 杂物房 仓库 倉庫 納戸 クローゼット 収納 物置 押入 パントリー クロゼット"
    " 食品库 ストレージ サービスルーム",
    "balcony": "阳台 陽台 陽臺 露台 露臺 ベランダ バルコニー テラス ウッドデッキ 生活阳台",
    "other": "车库 車庫 地下室 阁楼 設備 设备 管井 电梯 電梯 ガレージ 吹抜 花园 庭",
}


class RoomNameMatch(NamedTuple):
    """A phrase found in a name: where it starts, its functions, whether it leads (French)."""

    start: int
    functions: tuple[str, ...]
    leads: bool


def functions_from_name(name: str) -> tuple[str, ...]:
    """Functions of a room by its name; ``('other',)`` if the name says nothing.

    >>> functions_from_name("Cuisine ouverte / salon"), functions_from_name("主卧")
    (('kitchen', 'living'), ('double_bedroom',))
    """
    return sort_functions(functions for part in _parts(name) for functions in _of_part(part))


def _parts(name: str) -> list[str]:
    plain = fold_letters(name).replace("'s", "s").replace("’s", "s")
    return re.split(r"[/+&,;()|·・、]|\b(?:and|et|und)\b|\s[-–]\s", plain)


def says_nothing(name: str) -> bool:
    """Whether a room's name tells nothing of its use.

    >>> says_nothing("Zzyzx"), says_nothing("Garage"), says_nothing("Kitchen")
    (True, False, False)
    """
    return not any(map(_of_part, _parts(name)))


def sort_functions(functions: Iterable[str]) -> tuple[str, ...]:
    """Without doubles, and without the vague ones beside something more exact.

    >>> sort_functions(["bedroom", "child_bedroom", "other"])
    ('child_bedroom',)
    """
    found = list(dict.fromkeys(functions))
    vague = {"other"} if len(found) > 1 else set()
    if any(function.endswith("_bedroom") for function in found):
        vague.add("bedroom")
    if "bathroom" in found:
        vague |= {"toilet", "washroom"}
    return tuple(function for function in found if function not in vague) or ("other",)


def _of_part(part: str) -> tuple[str, ...]:
    """Functions of one part of a name: all of an open plan, else of the noun that counts."""
    found = sorted(_signs(part) + _words(part))
    functions = tuple(function for match in found for function in match.functions)
    if len(found) < 2 or OPEN_PLAN.issuperset(functions):
        return functions
    return found[0].functions if all(match.leads for match in found) else found[-1].functions


def _signs(part: str) -> list[RoomNameMatch]:
    found = []
    for phrase, functions in _sign_table():
        start = part.find(phrase)
        if start >= 0:
            found.append(RoomNameMatch(start, functions, False))
            part = part.replace(phrase, "\0" * len(phrase))
    return found


def _words(part: str) -> list[RoomNameMatch]:
    words = [_correct_spelling(word) for word in re.findall(r"[a-z]+", part)]
    table = _word_table()
    found, i = [], 0
    while i < len(words):
        for length in range(min(4, len(words) - i), 0, -1):
            hit = table.get(" ".join(words[i : i + length]))
            if hit is not None:
                found.append(RoomNameMatch(i, hit[0], hit[1]))
                i += length - 1
                break
        i += 1
    return found


@cache
def _correct_spelling(word: str) -> str:
    """The word as the table has it: as it is, singular, its known ending, or one slip away."""
    vocabulary = _vocabulary()
    if word in vocabulary or len(word) < 3:
        return word
    for ending in ("s", "es", "n", "e"):
        if word.endswith(ending) and word.removesuffix(ending) in vocabulary:
            return word.removesuffix(ending)
    for start in range(1, len(word) - 5):
        if word[start:] in vocabulary:
            return word[start:]
    close = difflib.get_close_matches(word, vocabulary, 1, 0.9) if len(word) > 5 else []
    return close[0] if close else word


@cache
def _word_table() -> dict[str, tuple[tuple[str, ...], bool]]:
    table: dict[str, tuple[tuple[str, ...], bool]] = {}
    for leads, rows in ((True, FIRST), (False, LAST)):
        for functions, phrases in rows.items():
            for phrase in phrases.split(";"):
                words = " ".join(_singular(word) for word in phrase.split())
                table[words] = table[phrase.strip()] = (tuple(functions.split()), leads)
    return table


def _singular(word: str) -> str:
    return word[:-1] if word.endswith("s") and len(word) > 4 else word


@cache
def _vocabulary() -> frozenset[str]:
    return frozenset(word for phrase in _word_table() for word in phrase.split())


@cache
def _sign_table() -> tuple[tuple[str, tuple[str, ...]], ...]:
    rows = ((sign, tuple(f.split())) for f, signs in SIGNS.items() for sign in signs.split())
    return tuple(sorted(rows, key=lambda row: -len(row[0])))
