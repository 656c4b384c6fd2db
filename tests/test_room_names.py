"""Functions of rooms by names in fifteen languages."""

from __future__ import annotations

from pathlib import Path
from typing import get_args

import pytest

from every import every
from scenewright import formats
from scenewright.building.room_names import functions_from_name, says_nothing, sort_functions
from scenewright.core.brief import Function

NAMES = [
    ("Bedroom 2", "bedroom"),
    ("Bedrom #3", "bedroom"),
    ("Bedroom #1", "bedroom"),
    ("BEDROOMS", "bedroom"),
    ("Master Bedroom", "double_bedroom"),
    ("Master bathroom", "bathroom"),
    ("Master bath", "bathroom"),
    ("Bedroom closet", "storage"),
    ("Kid's room", "child_bedroom"),
    ("Kids’ room", "child_bedroom"),
    ("Children's bedroom", "child_bedroom"),
    ("Nursery", "child_bedroom"),
    ("Living Room", "living"),
    ("Livingroom", "living"),
    ("living/dining", "living dining"),
    ("Living and dining", "living dining"),
    ("Kitchen-dining", "kitchen dining"),
    ("Kitchen / Diner", "kitchen"),
    ("Lounge diner", "living dining"),
    ("Family room", "living"),
    ("LDK", "living dining kitchen"),
    ("DK 6.0", "dining kitchen"),
    ("Salle de bain", "bathroom"),
    ("Salle de bains 2", "bathroom"),
    ("Salle d'eau", "bathroom"),
    ("WC", "toilet"),
    ("W.C.", "toilet"),
    ("Toilettes", "toilet"),
    ("Cuisine ouverte / salon", "kitchen living"),
    ("Séjour", "living"),
    ("Salon-séjour", "living dining"),
    ("Salle à manger", "dining"),
    ("Chambre parentale", "double_bedroom"),
    ("Chambre 3", "bedroom"),
    ("Chambre d'amis", "bedroom"),
    ("Chambre enfant", "child_bedroom"),
    ("Bureau", "study"),
    ("Placard chambre", "storage"),
    ("Entrée", "hall"),
    ("Couloir", "hall"),
    ("Dégagement", "hall"),
    ("Cellier", "storage"),
    ("Buanderie", "washroom"),
    ("Balcon", "balcony"),
    ("Terrasse", "balcony"),
    ("Kinderzimmer", "child_bedroom"),
    ("Kinderzimmer 2", "child_bedroom"),
    ("Wohn-/Esszimmer", "living dining"),
    ("Wohnzimmer", "living"),
    ("Wohnküche", "living kitchen"),
    ("Wohnen/Essen/Kochen", "living dining kitchen"),
    ("Abstellraum", "storage"),
    ("Flur", "hall"),
    ("Diele", "hall"),
    ("Küche", "kitchen"),
    ("Kueche", "kitchen"),
    ("Bad", "bathroom"),
    ("Badezimmer", "bathroom"),
    ("Gäste-WC", "toilet"),
    ("Elternschlafzimmer", "double_bedroom"),
    ("Schlafzimmer", "bedroom"),
    ("Arbeitszimmer", "study"),
    ("Büro", "study"),
    ("Gästezimmer", "bedroom"),
    ("Speisekammer", "storage"),
    ("Hauswirtschaftsraum", "washroom"),
    ("Balkon", "balcony"),
    ("Laundry", "washroom"),
    ("Utility room", "washroom"),
    ("Home office", "study"),
    ("Hallway", "hall"),
    ("Entrance hall", "hall"),
    ("Corridor", "hall"),
    ("Walk-in closet", "storage"),
    ("Pantry", "storage"),
    ("Terrace", "balcony"),
    ("Garage", "other"),
    ("Attic", "other"),
    ("", "other"),
    ("Xyzzy", "other"),
    ("Room 1", "other"),
    ("主卧", "double_bedroom"),
    ("主卧室", "double_bedroom"),
    ("主臥", "double_bedroom"),
    ("次卧", "bedroom"),
    ("卧室1", "bedroom"),
    ("儿童房", "child_bedroom"),
    ("兒童房", "child_bedroom"),
    ("客厅", "living"),
    ("客廳", "living"),
    ("客餐厅", "living dining"),
    ("客廳/餐廳", "living dining"),
    ("餐厅", "dining"),
    ("厨房", "kitchen"),
    ("廚房", "kitchen"),
    ("开放式厨房", "kitchen"),
    ("卫生间", "bathroom"),
    ("主卫", "bathroom"),
    ("主卧卫生间", "bathroom"),
    ("洗手间", "toilet"),
    ("书房", "study"),
    ("玄关", "hall"),
    ("走廊", "hall"),
    ("储物间", "storage"),
    ("衣帽间", "storage"),
    ("阳台", "balcony"),
    ("陽台", "balcony"),
    ("洋室", "bedroom"),
    ("洋室6帖", "bedroom"),
    ("和室", "bedroom"),
    ("ＬＤＫ", "living dining kitchen"),
    ("リビング", "living"),
    ("リビングダイニング", "living dining"),
    ("ダイニングキッチン", "dining kitchen"),
    ("リビング・ダイニング・キッチン", "living dining kitchen"),
    ("キッチン", "kitchen"),
    ("子供部屋", "child_bedroom"),
    ("トイレ", "toilet"),
    ("浴室", "bathroom"),
    ("洗面所", "washroom"),
    ("玄関", "hall"),
    ("廊下", "hall"),
    ("納戸", "storage"),
    ("バルコニー", "balcony"),
    ("寝室", "bedroom"),
    ("書斎", "study"),
    ("ウォークインクローゼット", "storage"),
    ("Bath/WC", "bathroom"),
    ("Bad/WC", "bathroom"),
    ("Study / guest room", "study bedroom"),
    ("Living Room with kitchen", "living kitchen"),
    ("Stairs", "hall"),
    ("Guest bathroom", "bathroom"),
    ("Powder room", "toilet"),
    ("En-suite", "bathroom"),
    ("Shower room", "bathroom"),
    ("Bathrom", "bathroom"),
    ("Dressing", "storage"),
    ("Parents", "double_bedroom"),
    ("Open kitchen", "kitchen"),
    ("Child 1", "child_bedroom"),
    ("Kitchen storage", "storage"),
    ("Wohn- und Esszimmer", "living dining"),
    ("KITCHEN/LIVING/DINING", "kitchen living dining"),
    ("子供部屋2", "child_bedroom"),
    ("Gäste WC", "toilet"),
    ("Chambre 1 - bureau", "bedroom study"),
]


@every(NAMES)
def test_function_by_name(name: str, functions: str) -> None:
    assert functions_from_name(name) == tuple(functions.split())


@every(NAMES)
def test_case_numbers_and_width_do_not_matter(name: str, functions: str) -> None:
    assert functions_from_name(f"  {name.upper()} 12") == tuple(functions.split())


def test_only_functions_the_brief_knows() -> None:
    known = set(get_args(Function))
    assert {f for name, _ in NAMES for f in functions_from_name(name)} <= known


def test_vague_functions_give_way() -> None:
    assert sort_functions(["other", "bedroom"]) == ("bedroom",)
    assert sort_functions(["bedroom", "single_bedroom", "bedroom"]) == ("single_bedroom",)
    assert sort_functions(["toilet", "bathroom"]) == ("bathroom",)
    assert sort_functions([]) == ("other",)


WORLD = """living: Гостиная, Salón, Soggiorno, Woonkamer, Pokój dzienny, Sala de estar, 거실, Obývací pokoj, Vardagsrum, Oturma odası
kitchen: Кухня, Cocina, Cucina, Keuken, Kuchnia, Cozinha, 주방, Kuchyně, Kök, Mutfak
dining: Столовая, Comedor, Sala da pranzo, Eetkamer, Jadalnia, Sala de jantar, 식당, Jídelna, Matsal, Yemek odası
bedroom: Спальня 2, Dormitorio, Camera da letto, Slaapkamer 1, Sypialnia, Quarto, 침실, Ložnice, Sovrum, Yatak odası
double_bedroom: Спальня родителей, Dormitorio principal, Camera matrimoniale, Ouderslaapkamer, Sypialnia rodziców, Quarto de casal, 안방, Ložnice rodičů, Föräldrasovrum, Ebeveyn yatak odası
child_bedroom: Детская, Habitación de los niños, Cameretta, Kinderkamer, Pokój dziecięcy, Quarto infantil, 아이방, Dětský pokoj, Barnrum, Çocuk odası
study: Кабинет, Despacho, Studio, Werkkamer, Gabinet, Escritório, 서재, Pracovna, Arbetsrum, Çalışma odası
bathroom: Санузел, Cuarto de baño, Bagno, Badkamer, Łazienka, Banheiro, 욕실, Koupelna, Badrum, Banyo
toilet: Туалет, Aseo, Gabinetto, Gastentoilet, Toaleta, Lavabo, 화장실, Záchod, Toalett, Tuvalet
washroom: Постирочная, Lavadero, Lavanderia, Bijkeuken, Pralnia, Área de serviço, 세탁실, Prádelna, Tvättstuga, Çamaşır odası
hall: Прихожая, Pasillo, Ingresso, Overloop, Przedpokój, Corredor, 현관, Předsíň, Entré, Giriş
storage: Кладовая, Trastero, Ripostiglio, Berging, Spiżarnia, Despensa, 창고, Šatna, Klädkammare, Kiler
balcony: Лоджия, Terraza, Balcone, Dakterras, Taras, Varanda, 베란다, Lodžie, Balkong, Teras
other: Гараж, Garaje, Giardino, Zolder, Piwnica, Garagem, 차고, Zahrada, Trädgård, Bahçe"""  # noqa: E501


@pytest.mark.parametrize("row", WORLD.splitlines())
def test_rooms_of_ten_more_languages(row: str) -> None:
    function, _, names = row.partition(": ")
    functions = {name: functions_from_name(name) for name in names.split(", ")}
    assert functions == dict.fromkeys(functions, (function,))
    assert not any(map(says_nothing, names.split(", ")))


def test_open_plans_of_other_languages() -> None:
    names = ("Кухня-гостиная", "Soggiorno con angolo cottura", "Sala e cozinha", "Kuchnia i salon")
    assert all({"kitchen", "living"} == {*functions_from_name(name)} for name in names)


def test_every_room_of_a_home_of_ten_languages_is_known() -> None:
    brief = formats.read(
        Path(__file__).parent / "data/field_cases/f13_room_names_nine_languages.json"
    )
    uses = [functions_from_name(room.name) for room in brief.rooms]
    assert len(uses) == 40
    assert ("other",) not in uses
