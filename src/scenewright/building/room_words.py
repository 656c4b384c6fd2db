"""Names of rooms in fifteen languages, by function.

Phrases in small letters without accents; a language more is more of them in each row. ``FIRST``
are those of languages that name the thing first ("placard chambre": Romance ones and Polish),
``LAST`` of those that name it last ("bedroom closet"), ``SIGNS`` of those that part no words. Rows
of two functions name rooms that are both.
"""

from __future__ import annotations

LAST = {
    "living": (
        "living; living room; livingroom; lounge; sitting room; family room; great room; "
        "drawing room; parlour; parlor; tv room; media room; sunroom; sun room; wohnzimmer; "
        "stube; wohnraum; wohnbereich; wohn; wohnen; kaminzimmer; l; woonkamer; zitkamer; "
        "huiskamer; zithoek; vardagsrum; allrum; finrum; oturma odasi; yasam alani; oturma "
        "alani; oturma; obyvaci pokoj; obyvak; obyvaci; гостиная; гостинная; зал; зала; общая "
        "комната; гостиная комната"
    ),
    "dining": (
        "dining; dining room; diningroom; dinette; breakfast nook; breakfast room; esszimmer; "
        "essbereich; essplatz; essecke; ess; essen; speisezimmer; eetkamer; eethoek; matsal; "
        "matplats; matrum; yemek odasi; yemek alani; jidelna; jidelni kout; столовая; "
        "столовая зона; обеденная зона"
    ),
    "kitchen": (
        "kitchen; kitchenette; kuche; kueche; kochnische; koch; kochen; pantry kitchen; k; "
        "keuken; kookhoek; kok; kokvra; pentry; allkok; mutfak; acik mutfak; amerikan mutfak; "
        "kuchyn; kuchyne; kuchynsky kout; кухня; кухонная зона; мини кухня"
    ),
    "living kitchen": "wohnkuche; wohnkueche; lk; woonkeuken; leefkeuken",
    "dining kitchen": "esskuche; esskueche; eat in kitchen; dk; kitchen diner; diner kitchen",
    "living dining": "lounge diner; living diner; ld",
    "living dining kitchen": "ldk; wohnesskuche; wohnesskueche",
    "bedroom": (
        "bedroom; bed room; bed; guest room; guestroom; guest; schlafzimmer; gastezimmer; "
        "gaestezimmer; zimmer; schlafraum; schlafen; gast; gaste; br; slaapkamer; kamer; "
        "logeerkamer; sovrum; rum; gastrum; yatak odasi; oda; odasi; misafir odasi; loznice; "
        "pokoj; pokoj pro hosty; спальня; спальная комната; комната; жилая комната; гостевая; "
        "гостевая комната"
    ),
    "double_bedroom": (
        "master bedroom; main bedroom; primary bedroom; parents bedroom; master; parent "
        "bedroom; double bedroom; principal bedroom; elternzimmer; elternschlafzimmer; "
        "eltern; doppelzimmer; hauptschlafzimmer; parents; parents room; master suite; "
        "primary suite; mbr; ouderslaapkamer; hoofdslaapkamer; grote slaapkamer; "
        "foraldrasovrum; huvudsovrum; stora sovrummet; foraldrarnas sovrum; ebeveyn yatak "
        "odasi; ebeveyn odasi; loznice rodicu; hlavni loznice; rodicovska loznice; главная "
        "спальня; спальня родителей; родительская спальня; хозяйская спальня; мастер спальня"
    ),
    "single_bedroom": "single bedroom; single room; maid room; maids room; einzelzimmer;"
    "staff bedroom",
    "child_bedroom": (
        "child; kid; children; kids; baby; child bedroom; children bedroom; childrens "
        "bedroom; childs bedroom; kids bedroom; kid bedroom; kids room; kid room; child room; "
        "childs room; children room; childrens room; boys room; girls room; boy room; girl "
        "room; nursery; playroom; play room; baby room; babys room; kinderzimmer; babyzimmer; "
        "kind; kinder; spielzimmer; jugendzimmer; kinderkamer; speelkamer; babykamer; "
        "kinderslaapkamer; tienerkamer; barnrum; barnkammare; lekrum; ungdomsrum; cocuk "
        "odasi; cocuk yatak odasi; bebek odasi; genc odasi; oyun odasi; detsky pokoj; detsky; "
        "detska; herna; pokojicek; детская; детская комната; детская спальня; игровая; "
        "игровая комната"
    ),
    "study": (
        "study; office; home office; den; library; work room; workroom; workspace; computer; "
        "arbeitszimmer; buro; buero; arbeiten; homeoffice; bibliothek; atelier; "
        "studierzimmer; werkkamer; kantoor; studeerkamer; bibliotheek; thuiskantoor; "
        "arbetsrum; kontor; bibliotek; hemmakontor; calisma odasi; ofis; kutuphane; pracovna; "
        "kancelar; knihovna; кабинет; рабочий кабинет; домашний офис; офис; библиотека"
    ),
    "bathroom": (
        "bath; bathroom; bath room; shower; shower room; master bath; ensuite; en suite; wet "
        "room; bad; badezimmer; dusche; duschbad; gastebad; gaestebad; hauptbad; elternbad; "
        "kinderbad; duschraum; ub; restroom with shower; badkamer; doucheruimte; douchekamer; "
        "badrum; dusch; duschrum; banyo; banyosu; dus; koupelna; sprcha; sprchovy kout; "
        "ванная; ванная комната; санузел; душевая; душ; совмещенный санузел"
    ),
    "toilet": (
        "toilet; wc; w c; lavatory; loo; powder room; restroom; rest room; half bath; "
        "cloakroom; toilette; gastewc; gaestewc; gaste wc; gaeste wc; klo; guest wc; guest "
        "toilet; gastentoilet; toalett; gasttoalett; gastwc; tuvalet; tuvaleti; zachod; "
        "toaleta; туалет; уборная; гостевой туалет; гостевой санузел"
    ),
    "washroom": (
        "laundry; laundry room; utility; utility room; washroom; wash room; washing room; "
        "waschkuche; waschkueche; waschraum; hauswirtschaftsraum; hwr; mud room; mudroom; "
        "bijkeuken; wasruimte; waskamer; washok; wasplaats; tvattstuga; tvatt; grovkok; "
        "groventre; kladvard; camasir odasi; camasirlik; camasirhane; pradelna; uklidova "
        "mistnost; прачечная; постирочная; хозяйственная комната"
    ),
    "hall": (
        "hall; hallway; corridor; entry; entrance; entrance hall; entryway; foyer; lobby; "
        "passage; passageway; landing; vestibule; porch; staircase; stairs; stairwell; "
        "stairway; flur; diele; gang; eingang; eingangsbereich; korridor; vorraum; vorzimmer; "
        "windfang; garderobe; treppe; treppenhaus; stairs hall; eingangshalle; halle; hal; "
        "entree; overloop; inkomhal; portaal; trap; trappenhuis; entre; hallen; farstu; "
        "trapphall; trappa; kapprum; hol; koridor; antre; giris; giris holu; merdiven; "
        "predsin; chodba; zadveri; schodiste; коридор; прихожая; холл; тамбур; вестибюль; "
        "лестница; лестничная клетка"
    ),
    "storage": (
        "storage; storage room; store; store room; storeroom; closet; walk in closet; walk "
        "in; wardrobe; wardrobe room; dressing; dressing room; pantry; larder; box room; "
        "cellar; linen; abstellraum; abstellkammer; abstell; kammer; speisekammer; "
        "vorratsraum; vorrat; ankleide; ankleidezimmer; lager; keller; kellerraum; speis; "
        "wic; sic; cl; schrankraum; berging; bergruimte; kast; inloopkast; kleedkamer; "
        "voorraadkast; provisiekast; kelder; bijkast; forrad; kladkammare; skafferi; "
        "garderob; kallare; kallarforrad; kiler; depo; giyinme odasi; gardirop; ardiye; kiler "
        "odasi; komora; spiz; spizirna; satna; sklep; sklad; кладовая; кладовка; гардероб; "
        "гардеробная; чулан; подсобное помещение"
    ),
    "balcony": (
        "balcony; terrace; patio; loggia; deck; veranda; verandah; balkon; terrasse; "
        "dachterrasse; roof terrace; wintergarten; outdoor; terras; dakterras; serre; "
        "balkong; altan; uteplats; terrass; teras; balkonu; terasa; lodzie; балкон; лоджия; "
        "терраса; веранда; крыльцо"
    ),
    "other": (
        "garage; carport; attic; basement; gym; boiler room; technical room; plant room; "
        "technikraum; heizungsraum; hobbyraum; dachboden; speicher; elevator; lift; shaft; "
        "schacht; aufzug; bar; sauna; pool; garten; garden; yard; void; luftraum; zolder; "
        "tuin; meterkast; technische ruimte; bergzolder; vind; tradgard; bastu; pannrum; "
        "garaj; bodrum; cati kati; bahce; asansor; kazan dairesi; garaz; puda; zahrada; "
        "technicka mistnost; kotelna; dilna; гараж; подвал; чердак; котельная; бойлерная; "
        "сад; сауна; лифт; мастерская"
    ),
}
FIRST = {
    "living": (
        "salon; sejour; salle de sejour; piece a vivre; piece de vie; salle de vie; sala; "
        "sala de estar; cuarto de estar; estar; salon principal; soggiorno; salotto; zona "
        "giorno; sala da giorno; sala de visitas; sala de tv; pokoj dzienny; salonik; pokoj "
        "goscinny"
    ),
    "dining": (
        "salle a manger; coin repas; coin repas salle; comedor; comedor diario; sala da "
        "pranzo; pranzo; zona pranzo; tinello; sala de jantar; jantar; copa; jadalnia; kacik "
        "jadalny"
    ),
    "living dining": "salon sejour; sejour double; salon comedor; sala comedor; salone",
    "kitchen": (
        "cuisine; coin cuisine; kitchenette; cuisinette; cocina; cocineta; office cocina; "
        "cucina; cucinino; angolo cottura; zona cottura; cozinha; kitchenet; kuchnia; aneks "
        "kuchenny; aneks"
    ),
    "bedroom": (
        "chambre; chambre a coucher; chambre d ami; chambre d amis; chb; ch; dormitorio; "
        "habitacion; cuarto; alcoba; recamara; habitacion de invitados; cuarto de invitados; "
        "camera; camera da letto; stanza; stanza da letto; camera degli ospiti; camera "
        "ospiti; quarto; quarto de hospedes; sypialnia; pokoj goscia; sypialnia goscinna"
    ),
    "double_bedroom": (
        "chambre parentale; chambre des parents; chambre parents; suite parentale; chambre "
        "principale; chambre double; chambre maitre; dormitorio principal; habitacion "
        "principal; recamara principal; dormitorio matrimonial; dormitorio doble; habitacion "
        "doble; dormitorio de los padres; camera matrimoniale; camera padronale; camera da "
        "letto matrimoniale; camera da letto padronale; matrimoniale; camera doppia; suite; "
        "suite principal; quarto de casal; quarto principal; quarto dos pais; sypialnia "
        "glowna; sypialnia rodzicow; sypialnia malzenska"
    ),
    "child_bedroom": (
        "chambre enfant; chambre d enfant; chambre des enfants; chambre bebe; chambre de "
        "bebe; chambre fille; chambre garcon; salle de jeux; chambre de fille; chambre de "
        "garcon; chambre ado; dormitorio infantil; habitacion infantil; cuarto infantil; "
        "dormitorio de ninos; habitacion de ninos; habitacion de los ninos; cuarto de los "
        "ninos; cuarto de ninos; cuarto de juegos; dormitorio juvenil; cameretta; camera dei "
        "bambini; camera bambini; stanza dei bambini; stanza bambini; camera dei ragazzi; "
        "camera ragazzi; quarto infantil; quarto das criancas; quarto de crianca; quarto de "
        "criancas; quarto do bebe; brinquedoteca; pokoj dzieciecy; pokoj dziecka; pokoj "
        "dzieci; pokoj dla dzieci; dzieciecy; pokoj zabaw"
    ),
    "single_bedroom": (
        "chambre simple; chambre de bonne; dormitorio individual; habitacion individual; "
        "dormitorio sencillo; camera singola; singola; quarto de solteiro; quarto de "
        "empregada; pokoj jednoosobowy"
    ),
    "study": (
        "bureau; bibliotheque; cabinet de travail; espace bureau; despacho; estudio; oficina; "
        "biblioteca; studio; ufficio; escritorio; gabinet; biuro; pracownia; biblioteka"
    ),
    "bathroom": (
        "salle de bain; sdb; salle d eau; sde; s d b; douche; bain; bains; bano; cuarto de "
        "bano; ducha; bano completo; bano principal; bagno; stanza da bagno; doccia; sala da "
        "bagno; banheiro; casa de banho; duche; banheiro social; lazienka; prysznic; pokoj "
        "kapielowy"
    ),
    "toilet": (
        "toilettes; cabinet de toilette; wc; cabinet; aseo; lavabo; retrete; medio bano; aseo "
        "de cortesia; servicio; gabinetto; servizio; servizio igienico; bagno di servizio; "
        "sanitario; toaleta; ubikacja"
    ),
    "washroom": (
        "buanderie; lingerie; lavadero; lavanderia; cuarto de lavado; zona de lavado; "
        "lavatoio; locale lavanderia; area de servico; lavandaria; pralnia; suszarnia"
    ),
    "hall": (
        "entree; couloir; degagement; hall d entree; palier; vestibule; escalier; sas; "
        "galerie; montee; circulation; pasillo; recibidor; vestibulo; entrada; distribuidor; "
        "escalera; zaguan; corridoio; ingresso; disimpegno; atrio; anticamera; scala; vano "
        "scala; pianerottolo; corredor; hall de entrada; circulacao; escada; escadas; "
        "przedpokoj; korytarz; wiatrolap; sien; schody; klatka schodowa; komunikacja"
    ),
    "storage": (
        "cellier; placard; debarras; rangement; cave; dressing; garde manger; reserve; local; "
        "remise; penderie; reduit; trastero; despensa; vestidor; almacen; armario; "
        "ripostiglio; dispensa; cabina armadio; guardaroba; cantina; sgabuzzino; deposito; "
        "arrumos; roupeiro; closet; garderoba; spizarnia; schowek; komorka; skladzik; "
        "pomieszczenie gospodarcze"
    ),
    "balcony": (
        "balcon; terrasse; veranda; loggia; terraza; porche; balcone; terrazzo; terrazza; "
        "varanda; sacada; terraco; alpendre; taras; weranda"
    ),
    "other": (
        "grenier; comble; garage; chaufferie; sous sol; jardin; vide; vide sur sejour; "
        "garaje; cochera; sotano; desvan; atico; autorimessa; soffitta; mansarda; giardino; "
        "locale tecnico; garagem; sotao; jardim; piwnica; strych; poddasze; kotlownia; ogrod"
    ),
}
SIGNS = {
    "living": (
        "客厅 客廳 客聽 起居室 起居厅 起居廳 会客厅 會客廳 家庭厅 家庭廳 居间 居間 リビング 거실"
    ),
    "dining": "餐厅 餐廳 饭厅 飯廳 食堂 ダイニング 餐区 식당 다이닝룸 식사실 다이닝",
    "kitchen": "厨房 廚房 厨 廚 台所 キッチン 주방 부엌",
    "living dining": "客餐厅 客餐廳 餐客厅 餐客廳 客饭厅 客飯廳 客厅餐厅",
    "dining kitchen": "餐厨 餐廚 ダイニングキッチン 식당겸주방",
    "bedroom": (
        "卧室 臥室 卧房 臥房 次卧 次臥 侧卧 客卧 客臥 睡房 寝室 洋室 和室 客房 客人房 老人房 "
        "长辈房 長輩房 父母房 卧 臥 ベッドルーム 客間 房间 房間 침실 방 작은방 손님방"
    ),
    "double_bedroom": (
        "主卧 主臥 主卧室 主臥室 主人房 主睡房 主寝室 夫妻房 夫婦寝室 双人房 雙人房 主卧房 "
        "主人卧室 안방 부부침실 부부방 큰방"
    ),
    "single_bedroom": "单人房 單人房 保姆房 保姆间 佣人房 傭人房 工人房",
    "child_bedroom": (
        "儿童房 兒童房 儿童卧室 小孩房 孩子房 女儿房 女兒房 儿子房 男孩房 女孩房 婴儿房 "
        "嬰兒房 宝宝房 游戏室 子供部屋 子ども部屋 こども部屋 キッズルーム 儿童间 아이방 "
        "아이들방 어린이방 자녀방 놀이방 아기방"
    ),
    "study": (
        "书房 書房 工作室 工作间 办公室 辦公室 办公 書斎 ワークスペース ワークルーム 仕事部屋 "
        "서재 작업실 공부방 사무실"
    ),
    "bathroom": (
        "卫生间 衛生間 浴室 主卫 主衛 次卫 次衛 公卫 公衛 客卫 客衛 内卫 外卫 卫浴 衛浴 卫 "
        "洗澡间 淋浴间 バスルーム 浴厕 風呂 ユニットバス バス シャワー 욕실 샤워실"
    ),
    "toilet": "厕所 廁所 洗手间 洗手間 厕 トイレ 便所 化粧室 お手洗 화장실 파우더룸",
    "washroom": (
        "洗衣房 洗衣间 洗衣間 洗衣室 洗面室 洗面所 洗面 脱衣室 洗面脱衣室 盥洗室 盥洗间 "
        "家务间 家事室 家政间 ランドリー ユーティリティ 세탁실 다용도실"
    ),
    "hall": (
        "玄关 玄關 走廊 过道 過道 门厅 門廳 走道 入口 玄関 廊下 ホール 楼梯 樓梯 楼梯间 "
        "樓梯間 階段 过厅 エントランス 현관 복도 계단 거실홀 전실"
    ),
    "storage": (
        "储藏室 儲藏室 储藏间 储物间 儲物間 储物室 儲物室 储藏 衣帽间 衣帽間 更衣室 更衣间 "
        "贮藏室 杂物间 雜物間 杂物房 仓库 倉庫 納戸 クローゼット 収納 物置 押入 パントリー "
        "クロゼット 食品库 ストレージ サービスルーム 드레스룸 창고 옷방 팬트리 수납실"
    ),
    "balcony": (
        "阳台 陽台 陽臺 露台 露臺 ベランダ バルコニー テラス ウッドデッキ 生活阳台 발코니 "
        "베란다 테라스"
    ),
    "other": (
        "车库 車庫 地下室 阁楼 設備 设备 管井 电梯 電梯 ガレージ 吹抜 花园 庭 차고 다락 "
        "다락방 지하실 정원 보일러실"
    ),
}
