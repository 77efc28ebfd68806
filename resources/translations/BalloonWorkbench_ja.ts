<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>App::Property</name>
    <message>
        <source>A line of text where the film is widest, as outlines</source>
        <translation>フィルムが最も広い所に入れる 1 行の文字（輪郭線として）</translation>
    </message>
    <message>
        <source>A ready body, made to measure</source>
        <translation>寸法を指定できる既製の立体</translation>
    </message>
    <message>
        <source>A size of the ready body</source>
        <translation>既製の立体の寸法</translation>
    </message>
    <message>
        <source>A tab with a hole to tie the balloon to, outside the weld</source>
        <translation>風船を結ぶための穴付きの耳（溶着線の外側）</translation>
    </message>
    <message>
        <source>Add what the balloon is filled through</source>
        <translation>風船をふくらませるための口を付ける</translation>
    </message>
    <message>
        <source>Air that it holds, as a share of what a round balloon of as much film would</source>
        <translation>入る空気の量（同じ量のフィルムで作る丸い風船に対する割合）</translation>
    </message>
    <message>
        <source>Another picture for the back; empty takes that of the front</source>
        <translation>裏面用の別の画像（空なら表と同じ）</translation>
    </message>
    <message>
        <source>Area of film inside the welds, all panels</source>
        <translation>溶着線の内側のフィルム面積（全パネル）</translation>
    </message>
    <message>
        <source>Area of the piece of film</source>
        <translation>フィルムの部品の面積</translation>
    </message>
    <message>
        <source>Around the balloon, in degrees Celsius</source>
        <translation>風船の周囲の温度（摂氏）</translation>
    </message>
    <message>
        <source>Automatic evens out a nearly symmetric picture, Forced any drawing: its left half is mirrored</source>
        <translation>「自動」はほぼ対称な絵を整え、「強制」はどんな図でも左半分を反転して対称にする</translation>
    </message>
    <message>
        <source>Corner relief: corners of the cuts are rounded so; the weld is not</source>
        <translation>角の逃げ：切り線の角をこの半径で丸める（溶着線は丸めない）</translation>
    </message>
    <message>
        <source>Corners of all loops</source>
        <translation>すべての輪の頂点</translation>
    </message>
    <message>
        <source>Corners of all welds</source>
        <translation>すべての溶着線の頂点</translation>
    </message>
    <message>
        <source>Corners of the pattern's seam</source>
        <translation>型紙の溶着線の頂点</translation>
    </message>
    <message>
        <source>Corners of the triangles on the flat film; z is not 0 where a face does not unroll</source>
        <translation>平らなフィルム上の三角形の頂点。平らに広がらない面では z が 0 になりません</translation>
    </message>
    <message>
        <source>Corners of the welds inside</source>
        <translation>内側の溶着線の頂点</translation>
    </message>
    <message>
        <source>Correct the pattern until the balloon looks like the drawing, or not</source>
        <translation>風船が図と同じ形に見えるまで型紙を補正するかどうか</translation>
    </message>
    <message>
        <source>Corrections of the pattern</source>
        <translation>型紙の補正回数</translation>
    </message>
    <message>
        <source>Diameter of a body from a file; 0 follows from the height, or the file</source>
        <translation>ファイルから読んだ立体の直径。0 なら高さかファイルから決まります</translation>
    </message>
    <message>
        <source>Direction of the grain, from the x axis of the drawing</source>
        <translation>フィルムの流れ方向（図の x 軸から測る）</translation>
    </message>
    <message>
        <source>Direction of the neck, counter-clockwise from the x axis</source>
        <translation>注入口の向き（x 軸から反時計回り）</translation>
    </message>
    <message>
        <source>Direction of the tab from the middle of the pattern</source>
        <translation>型紙の中心から見た耳の向き</translation>
    </message>
    <message>
        <source>Display mode when no map is shown</source>
        <translation>カラーマップを表示しないときの表示モード</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to</source>
        <translation>シルエットの 95 % が収まる距離</translation>
    </message>
    <message>
        <source>Distance that 95 % of the silhouette keep to if the weld creases</source>
        <translation>溶着線にしわが寄った場合にシルエットの 95 % が収まる距離</translation>
    </message>
    <message>
        <source>Dots per inch of the files</source>
        <translation>ファイルの解像度（dpi）</translation>
    </message>
    <message>
        <source>Edge at which the bag is filled, such as Sketch.Edge3; of a file or ready body: the panel and the number of a point, such as side.2, or the number of a seam; empty: as the file or body says</source>
        <translation>袋に空気を入れる辺（例：Sketch.Edge3）。ファイルや既製の立体では、パネル名と点の番号（例：side.2）か継ぎ目の番号。空ならファイルや立体のとおり</translation>
    </message>
    <message>
        <source>Edges that are joined, such as Sketch.Edge1=Sketch001.Edge3; edges that faces share need no word</source>
        <translation>つなぐ辺（例：Sketch.Edge1=Sketch001.Edge3）。面が共有する辺は書く必要がありません</translation>
    </message>
    <message>
        <source>Edges that stand for pieces of curves</source>
        <translation>曲線の一部を表す辺</translation>
    </message>
    <message>
        <source>Film left between pieces, and at the edges</source>
        <translation>部品の間と縁に残すフィルム</translation>
    </message>
    <message>
        <source>Film left outside the weld</source>
        <translation>溶着線の外側に残すフィルムの幅</translation>
    </message>
    <message>
        <source>Film of both panels with weld and intake, in grams</source>
        <translation>表裏 2 枚のフィルム、溶着部、注入口の重さ（グラム）</translation>
    </message>
    <message>
        <source>Film that wrinkles where it is compressed, or a shell that does not, for comparison</source>
        <translation>圧縮されるとしわになるフィルム、または比較用のしわにならないシェル</translation>
    </message>
    <message>
        <source>Film, model and solver of the result</source>
        <translation>結果に使われたフィルム、モデル、ソルバー</translation>
    </message>
    <message>
        <source>Find the place of the intake</source>
        <translation>注入口の位置を自動で決める</translation>
    </message>
    <message>
        <source>Fit inside width and height instead of stretching to both</source>
        <translation>幅と高さの両方に引き伸ばさず、その中に収める</translation>
    </message>
    <message>
        <source>Flat panels and their seams as JSON, in metres</source>
        <translation>平らなパネルと継ぎ目の JSON（メートル）</translation>
    </message>
    <message>
        <source>Folder that keeps finished balloons; empty: FreeCAD's cache folder</source>
        <translation>できた風船を残しておくフォルダー（空なら FreeCAD のキャッシュフォルダー）</translation>
    </message>
    <message>
        <source>Follow every change at once; switch it off for heavy models and inflate when you ask for it</source>
        <translation>変更にすぐ追従する。重いモデルではオフにし、必要なときにふくらませる</translation>
    </message>
    <message>
        <source>FreeCAD's material card that the values were taken from</source>
        <translation>値の元になった FreeCAD の材料カード</translation>
    </message>
    <message>
        <source>Gores that the accuracy needs, foretold from the profile</source>
        <translation>精度に必要なゴアの数（断面から予測）</translation>
    </message>
    <message>
        <source>Height above the sea</source>
        <translation>海抜高度</translation>
    </message>
    <message>
        <source>Height of a body from a file, along z; 0 follows</source>
        <translation>ファイルから読んだ立体の高さ（z 方向）。0 なら自動</translation>
    </message>
    <message>
        <source>Height of a body from a file; 0 follows</source>
        <translation>ファイルから読んだ立体の高さ。0 なら自動</translation>
    </message>
    <message>
        <source>Height of all that is cut</source>
        <translation>切る物全体の高さ</translation>
    </message>
    <message>
        <source>Height of its capital letters</source>
        <translation>大文字の高さ</translation>
    </message>
    <message>
        <source>Height of the drawing; 0 follows from the width</source>
        <translation>図の高さ（0 なら幅から決まる）</translation>
    </message>
    <message>
        <source>Height of the inflated balloon</source>
        <translation>ふくらんだ風船の高さ</translation>
    </message>
    <message>
        <source>Height of the outline</source>
        <translation>輪郭の高さ</translation>
    </message>
    <message>
        <source>Height of the piece of film</source>
        <translation>フィルム片の高さ</translation>
    </message>
    <message>
        <source>Height of the print with its marks</source>
        <translation>印を含む印刷の高さ</translation>
    </message>
    <message>
        <source>Height of the profile</source>
        <translation>断面の高さ</translation>
    </message>
    <message>
        <source>How a picture is read: holes of a filled shape stay, lines of a pen drawing are filled inside</source>
        <translation>画像の読み方：塗った形なら穴を残し、線画なら線の内側を塗る</translation>
    </message>
    <message>
        <source>How far along that seam, from 0 to 1 of its length; 0 takes its middle, or that of the edge</source>
        <translation>その継ぎ目に沿った位置（長さの 0～1）。0 なら継ぎ目か辺の中央</translation>
    </message>
    <message>
        <source>How far from the background what is drawn must be, of the greatest difference; 0 finds it</source>
        <translation>描いたものが背景からどれだけ離れていなければならないか、最大の差に対する割合。0 なら自動</translation>
    </message>
    <message>
        <source>How far the balloon may be from its profile or body on average, in parts of the diagonal</source>
        <translation>風船が断面や立体から平均でどれだけ離れてよいか（対角線に対する割合）</translation>
    </message>
    <message>
        <source>How far the print goes past the cut</source>
        <translation>印刷が切り線の外へはみ出す幅</translation>
    </message>
    <message>
        <source>How far the seams of a body of gores are farther out than the gores' centres</source>
        <translation>ゴアの立体で、継ぎ目がゴアの中央より外に出る量</translation>
    </message>
    <message>
        <source>How its lower and its upper end are closed</source>
        <translation>下端と上端の閉じ方</translation>
    </message>
    <message>
        <source>How large each was then [mm]</source>
        <translation>そのときの各部品の大きさ [mm]</translation>
    </message>
    <message>
        <source>How long the ripples are that are smoothed away, in pixels; 0 keeps all</source>
        <translation>ならして消す波の長さ、ピクセル。0 ならすべて残す</translation>
    </message>
    <message>
        <source>How many balloons are cut from the sheet</source>
        <translation>1 枚のシートから切り出す風船の数</translation>
    </message>
    <message>
        <source>How many balloons are worked out at a time; 0: one for each processor</source>
        <translation>同時に計算する風船の数。0 ならプロセッサーごとに 1 個</translation>
    </message>
    <message>
        <source>How many balloons of each pattern</source>
        <translation>型紙ごとの風船の数</translation>
    </message>
    <message>
        <source>How many gores; 0 takes as many as the accuracy needs</source>
        <translation>ゴアの数。0 なら精度に必要なだけ</translation>
    </message>
    <message>
        <source>How much longer one side of a seam may be, as a part of its length</source>
        <translation>継ぎ目の片側が長くてもよい量（長さに対する割合）</translation>
    </message>
    <message>
        <source>How the balloon is filled and closed</source>
        <translation>風船のふくらませ方と閉じ方</translation>
    </message>
    <message>
        <source>How the grain of pieces lies, where their film has one</source>
        <translation>部品の流れ方向（フィルムに流れ方向がある場合）</translation>
    </message>
    <message>
        <source>How the intake is made and used</source>
        <translation>注入口の作り方と使い方</translation>
    </message>
    <message>
        <source>How the lower end is closed</source>
        <translation>下端の閉じ方</translation>
    </message>
    <message>
        <source>How the outline was edited by hand: nodes moved, added and removed, one JSON text each</source>
        <translation>輪郭の手作業での編集：ノードの移動、追加、削除。1 つにつき 1 つの JSON テキスト</translation>
    </message>
    <message>
        <source>How the seams were changed: panels merged, seams cut and moved, one JSON text each</source>
        <translation>継ぎ目の変更：パネルの結合、継ぎ目の追加と移動。1 つにつき 1 つの JSON テキスト</translation>
    </message>
    <message>
        <source>How the upper end is closed</source>
        <translation>上端の閉じ方</translation>
    </message>
    <message>
        <source>How two panels of this film are joined</source>
        <translation>このフィルム 2 枚の接合方法</translation>
    </message>
    <message>
        <source>Inner width of the neck, or bore of the nozzle</source>
        <translation>首の内幅、またはノズルの内径</translation>
    </message>
    <message>
        <source>Into how many panels the body is divided; 0 takes the faces of a solid, 16 panels of a mesh; 1 takes only the seams that are drawn</source>
        <translation>立体を分けるパネルの数。0 ならソリッドは面ごと、メッシュは 16 枚。1 なら描いた継ぎ目だけを使います</translation>
    </message>
    <message>
        <source>It carries itself</source>
        <translation>自分の重さを支えて浮く</translation>
    </message>
    <message>
        <source>Its place, seen from its sketch</source>
        <translation>スケッチから見た位置</translation>
    </message>
    <message>
        <source>JSON file of panels and seams; a copy travels in the document</source>
        <translation>パネルと継ぎ目の JSON ファイル。写しが文書に入ります</translation>
    </message>
    <message>
        <source>Label of the values the mesh belongs to</source>
        <translation>このメッシュが対応する値の識別子</translation>
    </message>
    <message>
        <source>Label of what was laid out</source>
        <translation>並べたものの識別子</translation>
    </message>
    <message>
        <source>Label that the workbench has given it</source>
        <translation>ワークベンチが付けた表示名</translation>
    </message>
    <message>
        <source>Larger dimension before repairs, in mm</source>
        <translation>修正前の長い方の寸法（mm）</translation>
    </message>
    <message>
        <source>Largest diameter of the profile</source>
        <translation>断面の最大直径</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette</source>
        <translation>図とシルエットの最大の隔たり</translation>
    </message>
    <message>
        <source>Largest distance between drawing and silhouette if the weld creases</source>
        <translation>溶着線にしわが寄った場合の図とシルエットの最大の隔たり</translation>
    </message>
    <message>
        <source>Largest membrane tension in N/m</source>
        <translation>膜張力の最大値（N/m）</translation>
    </message>
    <message>
        <source>Largest strain of the film</source>
        <translation>フィルムの最大ひずみ</translation>
    </message>
    <message>
        <source>Lay panels first onto what is left of another layout, as its file says; the rest on the film</source>
        <translation>パネルをまず別の配置の残材（そのファイルのとおり）に並べ、残りをフィルムに並べる</translation>
    </message>
    <message>
        <source>Least bending stiffness, in units of the usual least one</source>
        <translation>曲げ剛性の下限（通常の下限を 1 とする）</translation>
    </message>
    <message>
        <source>Left open in welds that would cut off a part, so wide; 0 gives each part an intake of its own</source>
        <translation>部分を切り離してしまう溶着線に残す通路の幅。0 なら部分ごとに注入口を付ける</translation>
    </message>
    <message>
        <source>Length of a notch; at most the allowance</source>
        <translation>合印の長さ（外側の余白以下）</translation>
    </message>
    <message>
        <source>Length of a sheet; 0 is a roll</source>
        <translation>シートの長さ（0 はロール）</translation>
    </message>
    <message>
        <source>Length of all seams on the body</source>
        <translation>立体の上のすべての継ぎ目の長さ</translation>
    </message>
    <message>
        <source>Length of all welds on it</source>
        <translation>含まれる溶着線の全長</translation>
    </message>
    <message>
        <source>Length of its welds</source>
        <translation>この部品の溶着線の長さ</translation>
    </message>
    <message>
        <source>Length of the natural shape's gores, from its lower to its upper end</source>
        <translation>自然形のゴアの長さ（下端から上端まで）</translation>
    </message>
    <message>
        <source>Length of the neck from the seam outward, or diameter of the flange; 0 takes the usual one</source>
        <translation>溶着線から外へ伸びる首の長さ、またはフランジの直径。0 なら通常の値</translation>
    </message>
    <message>
        <source>Length of the profile from end to end</source>
        <translation>断面の線の端から端までの長さ</translation>
    </message>
    <message>
        <source>Length of the roll that is used</source>
        <translation>使うロールの長さ</translation>
    </message>
    <message>
        <source>Length of the weld</source>
        <translation>溶着線の長さ</translation>
    </message>
    <message>
        <source>Lengths of both sides of each seam in mm</source>
        <translation>各継ぎ目の両側の長さ（mm）</translation>
    </message>
    <message>
        <source>Lines and arcs within 0.02 mm in place of many short lines</source>
        <translation>多数の短い線の代わりに、誤差 0.02 mm 以内の直線と円弧を使う</translation>
    </message>
    <message>
        <source>Longest piece of the side band; 0 is the width of the film</source>
        <translation>側面の帯の 1 本の最大長さ。0 ならフィルムの幅</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette</source>
        <translation>図とシルエットの平均の隔たり</translation>
    </message>
    <message>
        <source>Mean distance between drawing and silhouette if the weld creases</source>
        <translation>溶着線にしわが寄った場合の図とシルエットの平均の隔たり</translation>
    </message>
    <message>
        <source>Names of the panels</source>
        <translation>パネルの名前</translation>
    </message>
    <message>
        <source>Names of the panels and other pieces</source>
        <translation>パネルとほかの部品の名前</translation>
    </message>
    <message>
        <source>Names of the pieces that have been arranged</source>
        <translation>並べ替えた部品の名前</translation>
    </message>
    <message>
        <source>Notches to lay both films on each other by, evenly along the cut; of many panels, groups of them on each seam, 0 as many as its length needs</source>
        <translation>2 枚のフィルムを重ねるための合印。切り線に沿って等間隔に付きます。複数パネルでは継ぎ目ごとの合印の組で、0 なら長さに必要なだけ</translation>
    </message>
    <message>
        <source>Number of balloons in the table</source>
        <translation>表にある風船の数</translation>
    </message>
    <message>
        <source>Number of balloons that are worked out</source>
        <translation>計算済みの風船の数</translation>
    </message>
    <message>
        <source>Number of balloons that cannot be made</source>
        <translation>作れない風船の数</translation>
    </message>
    <message>
        <source>Number of corners of each loop</source>
        <translation>各輪の頂点数</translation>
    </message>
    <message>
        <source>Number of corners of each seam</source>
        <translation>各溶着線（外周）の頂点数</translation>
    </message>
    <message>
        <source>Number of corners of each weld</source>
        <translation>各内側溶着線の頂点数</translation>
    </message>
    <message>
        <source>Number of flat panels that it is made of; 0: two equal ones</source>
        <translation>平らなパネルの数。0 なら同じ 2 枚</translation>
    </message>
    <message>
        <source>Number of holes</source>
        <translation>穴の数</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>パネルの数</translation>
    </message>
    <message>
        <source>Number of pieces on what is shown</source>
        <translation>表示中のシートの部品数</translation>
    </message>
    <message>
        <source>Number of seams between them</source>
        <translation>パネル間の継ぎ目の数</translation>
    </message>
    <message>
        <source>Number of seams, then the number of vertices of each seam and weld</source>
        <translation>外周の数、続いて各外周・溶着線の節点数</translation>
    </message>
    <message>
        <source>Number of sheets</source>
        <translation>シートの枚数</translation>
    </message>
    <message>
        <source>Number of the sheet that is shown and exported</source>
        <translation>表示して書き出すシートの番号</translation>
    </message>
    <message>
        <source>Of many panels, for each seam: both panels, number of vertices, then those of either side</source>
        <translation>複数パネルの各継ぎ目：両方のパネル、節点の数、続いて各側の節点</translation>
    </message>
    <message>
        <source>Of many panels, for each: number of vertices, of triangles and of loops</source>
        <translation>複数パネルのそれぞれ：節点、三角形、境界の数</translation>
    </message>
    <message>
        <source>Of many panels, how much longer one side of a seam may be</source>
        <translation>複数パネルで、継ぎ目の片側が長くてもよい量</translation>
    </message>
    <message>
        <source>Of warm air, in degrees Celsius</source>
        <translation>熱気の温度（摂氏）</translation>
    </message>
    <message>
        <source>On which remnant each sheet is, -1 for none</source>
        <translation>各シートがどの残材にあるか（-1 はなし）</translation>
    </message>
    <message>
        <source>Only one side of this film can be joined so</source>
        <translation>このフィルムは片面しかそのように接合できない</translation>
    </message>
    <message>
        <source>Panel of each triangle</source>
        <translation>各三角形のパネル</translation>
    </message>
    <message>
        <source>Panels and seams as JSON, in metres</source>
        <translation>パネルと継ぎ目の JSON（メートル）</translation>
    </message>
    <message>
        <source>Panels that are cut, each with what is equal to it</source>
        <translation>切り出すパネルと、それと同じ形のもの</translation>
    </message>
    <message>
        <source>Part of the film that the pieces take, in per cent</source>
        <translation>部品が占めるフィルムの割合（%）</translation>
    </message>
    <message>
        <source>Part of the film's area that hangs loose</source>
        <translation>たるんでいるフィルム面積の割合</translation>
    </message>
    <message>
        <source>Part of the film's area that is wrinkled</source>
        <translation>しわになっているフィルム面積の割合</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON file; a copy travels in the document</source>
        <translation>画像、SVG、DXF、JSON のファイル（コピーが文書に入る）</translation>
    </message>
    <message>
        <source>Place of the intake: counter-clockwise along the outer seam from its rightmost point</source>
        <translation>注入口の位置：外周の右端から反時計回りに測った長さ</translation>
    </message>
    <message>
        <source>Places of the outline that move if the weld creases, the worst first</source>
        <translation>溶着線にしわが寄ると輪郭が動く位置（動きの大きい順）</translation>
    </message>
    <message>
        <source>Points of the body's triangles</source>
        <translation>立体の三角形の点</translation>
    </message>
    <message>
        <source>Points of the profile: radius, 0, height</source>
        <translation>断面の点：半径、0、高さ</translation>
    </message>
    <message>
        <source>Poisson's ratio of the film</source>
        <translation>フィルムのポアソン比</translation>
    </message>
    <message>
        <source>Polymer of the side that is welded, such as PE; none where it does not weld, empty: not known</source>
        <translation>溶着する面のポリマー（PE など）。溶着できなければ none、空なら不明</translation>
    </message>
    <message>
        <source>Pressure in the inflated balloon</source>
        <translation>ふくらんだ風船の内圧</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>内圧（外気圧との差）</translation>
    </message>
    <message>
        <source>Put the tab opposite the intake</source>
        <translation>耳を注入口の反対側に付ける</translation>
    </message>
    <message>
        <source>Remarks made during the design</source>
        <translation>設計中の注意</translation>
    </message>
    <message>
        <source>Remarks made while the body was read</source>
        <translation>立体を読んだときの注意</translation>
    </message>
    <message>
        <source>Remarks made while the outline was found</source>
        <translation>輪郭抽出中の注意</translation>
    </message>
    <message>
        <source>Remarks made while the panels were read</source>
        <translation>パネルを読んだときの注意</translation>
    </message>
    <message>
        <source>Remarks made while the pattern was drawn</source>
        <translation>型紙作図中の注意</translation>
    </message>
    <message>
        <source>Remarks made while the profile was read</source>
        <translation>断面を読んだときの注意</translation>
    </message>
    <message>
        <source>Remarks on the layout</source>
        <translation>配置についての注意</translation>
    </message>
    <message>
        <source>Repairs that were made in the drawing, one each; delete an entry to take it back</source>
        <translation>図に加えた修正（1 行に 1 つ）。行を消すと元に戻る</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>凡例付きで色表示する結果</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF, STEP, IGES or BREP file of a closed body; a copy travels in the document</source>
        <translation>閉じた立体の STL、OBJ、PLY、3MF、STEP、IGES、BREP ファイル。写しが文書に入ります</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON file of half the outline; a copy travels in the document</source>
        <translation>輪郭の半分の SVG、DXF、JSON ファイル。写しが文書に入ります</translation>
    </message>
    <message>
        <source>Seams by the number on both edges, with their lengths</source>
        <translation>両方の辺に付く番号順の継ぎ目とその長さ</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>図とシルエットを重ねて表示する</translation>
    </message>
    <message>
        <source>Simulate both panels instead of one and its mirror image</source>
        <translation>1 枚とその鏡像ではなく 2 枚とも計算する</translation>
    </message>
    <message>
        <source>Size of the body along x, y and z</source>
        <translation>立体の大きさ（x、y、z 方向）</translation>
    </message>
    <message>
        <source>Size of the triangles; 0 is automatic</source>
        <translation>三角形の大きさ（0 は自動）</translation>
    </message>
    <message>
        <source>Sketch or wire of half the outline, which the body follows</source>
        <translation>立体が従う、輪郭の半分のスケッチまたはワイヤー</translation>
    </message>
    <message>
        <source>Sketch, wire or face that the outline follows instead of a file</source>
        <translation>ファイルの代わりに輪郭が追従するスケッチ、ワイヤー、面</translation>
    </message>
    <message>
        <source>Sketches are projected onto the side that is nearer to them only</source>
        <translation>スケッチを、近い側の面だけに投影します</translation>
    </message>
    <message>
        <source>Sketches whose lines are seams: they are projected onto the body along the normal of their plane</source>
        <translation>線が継ぎ目になるスケッチ。スケッチ平面の法線の方向に立体へ投影します</translation>
    </message>
    <message>
        <source>Sketches, wires and flat faces that are the panels, each seen from outside</source>
        <translation>パネルになるスケッチ、ワイヤー、平らな面（外から見た向き）</translation>
    </message>
    <message>
        <source>Smaller holes, of the area of their shape, are filled</source>
        <translation>形の面積に対してこれより小さい穴は塗りつぶす</translation>
    </message>
    <message>
        <source>Smooth stretches as single splines in place of arcs</source>
        <translation>滑らかな区間を円弧ではなく 1 本のスプラインにする</translation>
    </message>
    <message>
        <source>So far outside of the body, or inside, the film lies at least</source>
        <translation>フィルムが立体の外側（または内側）に最低限離れる距離</translation>
    </message>
    <message>
        <source>Solid or mesh that the balloon is to fill, which it follows</source>
        <translation>風船で満たすソリッドまたはメッシュ。風船はこれに従います</translation>
    </message>
    <message>
        <source>Solver that was used</source>
        <translation>使われたソルバー</translation>
    </message>
    <message>
        <source>Solver: compiled, NumPy, or the best of them; Newmark follows the inflation in time, slowly</source>
        <translation>ソルバー：コンパイル版、NumPy、またはその最良のもの。Newmark は膨張を時間とともに追うが遅い</translation>
    </message>
    <message>
        <source>Steps of the solver in the last inflation</source>
        <translation>最後の膨張計算のステップ数</translation>
    </message>
    <message>
        <source>Stiffness of a weld in its plane, in parts of what both films have there when they stay flat</source>
        <translation>溶着線の面内の剛性（そこで 2 枚のフィルムが平らなままのときの値を 1 とする）</translation>
    </message>
    <message>
        <source>Tension over the section at which the film tears; 0: not known</source>
        <translation>フィルムが破れる断面応力（0：不明）</translation>
    </message>
    <message>
        <source>The balloon of a row that was shown last</source>
        <translation>最後に表示した行の風船</translation>
    </message>
    <message>
        <source>The balloon shown has come to rest</source>
        <translation>表示している風船が静止している</translation>
    </message>
    <message>
        <source>The balloon that is cut from this pattern</source>
        <translation>この型紙から作る風船</translation>
    </message>
    <message>
        <source>The balloon that is varied</source>
        <translation>値を変えてみる風船</translation>
    </message>
    <message>
        <source>The film resists bending</source>
        <translation>フィルムの曲げ剛性を考える</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks; empty has crosses for the eye</source>
        <translation>位置合わせの印で印刷を見つける機械（空なら目で合わせる十字）</translation>
    </message>
    <message>
        <source>The outline whose drawing this one shares; empty: its own</source>
        <translation>同じ図を使う元の輪郭（空なら自分の図）</translation>
    </message>
    <message>
        <source>The pattern that is printed</source>
        <translation>印刷する型紙</translation>
    </message>
    <message>
        <source>The pattern that it is a piece of</source>
        <translation>この部品が属する型紙</translation>
    </message>
    <message>
        <source>The patterns that are laid out</source>
        <translation>並べる型紙</translation>
    </message>
    <message>
        <source>The pressure is that at the lower end and rises with the height, as the gas is lighter than air</source>
        <translation>圧力は下端での値で、気体が空気より軽いため高いほど大きくなります</translation>
    </message>
    <message>
        <source>The seams in the order of the work</source>
        <translation>作業順の継ぎ目</translation>
    </message>
    <message>
        <source>The second panel beside the first, mirrored; else cut twice</source>
        <translation>2 枚目を反転して 1 枚目の隣に置く（しない場合は 2 回切る）</translation>
    </message>
    <message>
        <source>The side that is shown and exported for a cutter</source>
        <translation>表示し、カッター用に書き出す面</translation>
    </message>
    <message>
        <source>The silhouette is within the tolerance of the drawing</source>
        <translation>シルエットが図の許容差内にある</translation>
    </message>
    <message>
        <source>The spreadsheet: headings in its first row, a balloon in each below</source>
        <translation>表計算シート：1 行目は見出し、その下は 1 行に 1 個の風船</translation>
    </message>
    <message>
        <source>The whole report as JSON</source>
        <translation>レポート全体（JSON）</translation>
    </message>
    <message>
        <source>The workbench has given it a place</source>
        <translation>位置が決まっている（新しいオブジェクトには自動で位置が決まる）</translation>
    </message>
    <message>
        <source>Thickness of the balloon, from which the side band follows; 0 takes the band's own width</source>
        <translation>風船の厚さ。側面の帯の幅が決まります。0 なら帯の幅を使います</translation>
    </message>
    <message>
        <source>Thickness of the film</source>
        <translation>フィルムの厚さ</translation>
    </message>
    <message>
        <source>Thickness of the inflated balloon</source>
        <translation>ふくらんだ風船の厚み</translation>
    </message>
    <message>
        <source>Three places on each of these, flat</source>
        <translation>それぞれの上の 3 つの位置（平らな状態）</translation>
    </message>
    <message>
        <source>Three points of each triangle</source>
        <translation>各三角形の 3 つの点</translation>
    </message>
    <message>
        <source>Two points of each edge at which a panel is cut open</source>
        <translation>パネルを切り開く各辺の 2 つの点</translation>
    </message>
    <message>
        <source>Up to date, or what is wrong</source>
        <translation>最新か、または問題の内容</translation>
    </message>
    <message>
        <source>Version of this object's properties</source>
        <translation>このオブジェクトのプロパティの版</translation>
    </message>
    <message>
        <source>Vertices along all seams, then along all welds inside</source>
        <translation>すべての外周の節点、続いて内側の溶着線の節点</translation>
    </message>
    <message>
        <source>Vertices of each triangle</source>
        <translation>各三角形の節点</translation>
    </message>
    <message>
        <source>Vertices of the flat panel</source>
        <translation>平らなフィルムの節点</translation>
    </message>
    <message>
        <source>Vertices of the inflated upper film</source>
        <translation>ふくらんだ上側フィルムの節点</translation>
    </message>
    <message>
        <source>Vertices of the lower film where both were simulated</source>
        <translation>2 枚とも計算した場合の下側フィルムの節点</translation>
    </message>
    <message>
        <source>Volume of the balloon, from which the pressure follows</source>
        <translation>風船の体積（ここから圧力が決まる）</translation>
    </message>
    <message>
        <source>Volume of the body</source>
        <translation>立体の体積</translation>
    </message>
    <message>
        <source>Volume of the inflated balloon</source>
        <translation>ふくらんだ風船の体積</translation>
    </message>
    <message>
        <source>Volume that decides the size</source>
        <translation>大きさを決める体積</translation>
    </message>
    <message>
        <source>Weight of the film in kg per square metre</source>
        <translation>フィルムの重さ（kg/m²）</translation>
    </message>
    <message>
        <source>Weld that resists bending in its plane, or film that crumples there freely, the worst for a ring</source>
        <translation>面内の曲げに抵抗する溶着線、またはそこで自由にしわが寄るフィルム（輪には最も厳しい）</translation>
    </message>
    <message>
        <source>What decides the size: the outline as it is, a volume to hold or a load to carry</source>
        <translation>大きさを決めるもの：輪郭のまま、入る体積、または持ち上げる重さ</translation>
    </message>
    <message>
        <source>What does not fit yet, a sentence each</source>
        <translation>まだ合わないところ（1 件 1 文）</translation>
    </message>
    <message>
        <source>What each edge of the shape is called</source>
        <translation>形の各辺の名前</translation>
    </message>
    <message>
        <source>What fills it when it shall float</source>
        <translation>浮かせるときに入れる気体</translation>
    </message>
    <message>
        <source>What is given: the pressure, or the volume that it shall reach</source>
        <translation>与えるもの：圧力、または目標の体積</translation>
    </message>
    <message>
        <source>What is printed; empty takes the picture or painting of the outline</source>
        <translation>印刷する絵（空なら輪郭の画像や絵）</translation>
    </message>
    <message>
        <source>What is thinner, of the size of the drawing, is a line whose inside is filled; 0 keeps all holes</source>
        <translation>図の大きさに対してこれより細いものは線とし、その内側を塗りつぶす。0 ならすべての穴を残す</translation>
    </message>
    <message>
        <source>What it carries with its gas, in grams; below 0 it sinks</source>
        <translation>気体で持ち上げられる重さ（グラム）。0 未満なら沈む</translation>
    </message>
    <message>
        <source>What it is called on the pattern</source>
        <translation>型紙での名前</translation>
    </message>
    <message>
        <source>What it is to be: an outline, a body of gores or a bag</source>
        <translation>何を作るか：輪郭、ゴアの立体、または袋</translation>
    </message>
    <message>
        <source>What it shall carry besides itself, in grams; 0 makes it float just so</source>
        <translation>自重のほかに持ち上げる重さ（グラム）。0 ならちょうど浮く</translation>
    </message>
    <message>
        <source>What tells where the intake is</source>
        <translation>注入口の位置の指定方法</translation>
    </message>
    <message>
        <source>What the balloon is made of; Custom lets you give your own values</source>
        <translation>風船の材料。「カスタム」では値を自分で入れる</translation>
    </message>
    <message>
        <source>What the body was read from</source>
        <translation>立体の読み込み元</translation>
    </message>
    <message>
        <source>What the design of many panels has figures, as JSON</source>
        <translation>複数パネルの設計の数値（JSON）</translation>
    </message>
    <message>
        <source>What the outline was read from</source>
        <translation>輪郭の読み込み元</translation>
    </message>
    <message>
        <source>What the panels were read from</source>
        <translation>パネルの読み込み元</translation>
    </message>
    <message>
        <source>What the profile was read from</source>
        <translation>断面の読み込み元</translation>
    </message>
    <message>
        <source>What to do along each wire of the shape</source>
        <translation>形状の各ワイヤーに沿って行う加工</translation>
    </message>
    <message>
        <source>What would make the balloon better</source>
        <translation>風船をよりよくする助言</translation>
    </message>
    <message>
        <source>Where a balloon of many panels is filled: the number of a seam, or a panel and the point at which an edge begins, such as top.2; a panel alone has a nozzle in its middle</source>
        <translation>複数パネルの風船に空気を入れる所：継ぎ目の番号、またはパネルと辺の始まる点（例：top.2）。パネル名だけなら中央にノズル</translation>
    </message>
    <message>
        <source>Where all pieces lie, as JSON</source>
        <translation>すべての部品の位置（JSON）</translation>
    </message>
    <message>
        <source>Where it is found: farthest from the centre, or low, where a tied balloon hangs straight</source>
        <translation>自動で決める位置：中心から最も遠い所、または結んだ風船が真っすぐ下がる低い所</translation>
    </message>
    <message>
        <source>Where the middle of each lies, turned and mirrored</source>
        <translation>各部品の中心の位置、回転、反転</translation>
    </message>
    <message>
        <source>Where the profile comes from without a sketch: a file, or the shape of a balloon without weight</source>
        <translation>スケッチがないときの断面：ファイル、または重さのない風船の形</translation>
    </message>
    <message>
        <source>Where the workbench put it</source>
        <translation>自動で置かれた位置（ユーザーが動かした場合を除く）</translation>
    </message>
    <message>
        <source>Whether a laser may cut this film</source>
        <translation>このフィルムをレーザーで切ってよいかどうか</translation>
    </message>
    <message>
        <source>Whether the balloon follows the body, encloses or lines it</source>
        <translation>風船が立体に沿うか、立体を包むか、内側に張るか</translation>
    </message>
    <message>
        <source>Which edges are joined</source>
        <translation>つながっている辺</translation>
    </message>
    <message>
        <source>Which film is laid out: pieces of a valve are on one of their own</source>
        <translation>並べるフィルム（弁の部品は別のフィルムから切る）</translation>
    </message>
    <message>
        <source>Which of them each wire belongs to; 0: a copy</source>
        <translation>各ワイヤーがどれに属するか。0 は写し</translation>
    </message>
    <message>
        <source>Which piece of the pattern it is, from 1</source>
        <translation>型紙の何番目の部品か（1 から）</translation>
    </message>
    <message>
        <source>Which shape of the drawing it is; 1 is the largest</source>
        <translation>図の何番目の形か（1 が最大）</translation>
    </message>
    <message>
        <source>Width from which it carries itself; 0 when never</source>
        <translation>自分の重さで浮く最小の幅（0：浮かない）</translation>
    </message>
    <message>
        <source>Width of a body from a file, along x; 0 follows from the height, or the file</source>
        <translation>ファイルから読んだ立体の幅（x 方向）。0 なら高さかファイルから決まります</translation>
    </message>
    <message>
        <source>Width of a side band between front and back; 0 is two panels</source>
        <translation>表と裏の間の側面の帯の幅。0 なら 2 枚のパネル</translation>
    </message>
    <message>
        <source>Width of all that is cut</source>
        <translation>切る物全体の幅</translation>
    </message>
    <message>
        <source>Width of the drawing; 0 follows from the height</source>
        <translation>図の幅（0 なら高さから決まる）</translation>
    </message>
    <message>
        <source>Width of the inflated balloon</source>
        <translation>ふくらんだ風船の幅</translation>
    </message>
    <message>
        <source>Width of the outline</source>
        <translation>輪郭の幅</translation>
    </message>
    <message>
        <source>Width of the piece of film</source>
        <translation>フィルム片の幅</translation>
    </message>
    <message>
        <source>Width of the print with its marks</source>
        <translation>印を含む印刷の幅</translation>
    </message>
    <message>
        <source>Width of the roll or sheet</source>
        <translation>ロールまたはシートの幅</translation>
    </message>
    <message>
        <source>Width of the weld that this film needs</source>
        <translation>このフィルムに必要な溶着幅</translation>
    </message>
    <message>
        <source>Width of the weld; 0 takes the film's</source>
        <translation>溶着幅（0 ならフィルムの値）</translation>
    </message>
    <message>
        <source>Young's modulus across the grain; 0 means no grain</source>
        <translation>流れ方向に直角のヤング率（0 は方向性なし）</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>フィルムのヤング率</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench</name>
    <message>
        <source> It may have lacked memory: take a coarser mesh.</source>
        <translation>メモリーが足りなかった可能性があります。メッシュを粗くしてください。</translation>
    </message>
    <message>
        <source> is not ready: </source>
        <translation> の準備ができていません：</translation>
    </message>
    <message>
        <source>"hosts" is no list: write {0}.</source>
        <translation>「hosts」はリストではありません。{0} のように書いてください。</translation>
    </message>
    <message>
        <source>"{0}" cannot be read: write {"kind": "latin-hypercube", "rows": 100, "seed": 1}.</source>
        <translation>「{0}」を読み取れません。{"kind": "latin-hypercube", "rows": 100, "seed": 1} のように書いてください。</translation>
    </message>
    <message>
        <source>"{0}" has one result and its value: write {"lift": "20 g"}.</source>
        <translation>「{0}」には結果 1 つとその値を書きます。{"lift": "20 g"} のように書いてください。</translation>
    </message>
    <message>
        <source>"{0}" is an edge of {1} panels: name the face too, as in {2}.</source>
        <translation>「{0}」は {1} 枚のパネルの辺です。{2} のように面も書いてください。</translation>
    </message>
    <message>
        <source>"{0}" is no choice for a pattern larger than the bed: choose {1}.</source>
        <translation>大きすぎる型紙の扱い方「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>"{0}" is no colour: give one such as "#cc294d".</source>
        <translation>「{0}」は色ではありません。「#cc294d」のように入力してください。</translation>
    </message>
    <message>
        <source>"{0}" is no edge of a panel: write it as in {1}.0, or give the number of a seam, 1 to {2}. There are the panels {3}{4}.</source>
        <translation>「{0}」はパネルの辺ではありません。{1}.0 のように書くか、継ぎ目の番号 1～{2} を指定してください。パネルは {3}{4} です。</translation>
    </message>
    <message>
        <source>"{0}" is no sum of L, W, S, A and millimetres, such as "0.5 W + 2".</source>
        <translation>「{0}」は「0.5 W + 2」のような L、W、S、A とミリメートルの和ではありません。</translation>
    </message>
    <message>
        <source>"{0}" may not use {1}.</source>
        <translation>「{0}」では {1} を使えません。</translation>
    </message>
    <message>
        <source>"{0}" of "{1}" is no whole number: write one.</source>
        <translation>「{1}」の「{0}」は整数ではありません。整数を書いてください。</translation>
    </message>
    <message>
        <source>"{0}" of the study is no JSON object: write {"width": ...}.</source>
        <translation>スタディの「{0}」は JSON オブジェクトではありません。{"width": ...} のように書いてください。</translation>
    </message>
    <message>
        <source>"{0}" of the study is no list of JSON objects: write [{"input": ...}, ...].</source>
        <translation>スタディの「{0}」は JSON オブジェクトのリストではありません。[{"input": ...}, ...] のように書いてください。</translation>
    </message>
    <message>
        <source>"{0}" says what may be chosen: write {"width": ["100mm", "400mm"]}.</source>
        <translation>「{0}」には選べるものを書きます。{"width": ["100mm", "400mm"]} のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' cannot be kept: write {1} or {2}.</source>
        <translation>「{0}」は保存できません。{1} か {2} と書いてください。</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}). Check the name and its access.</source>
        <translation>「{0}」を読めません（{1}）。名前とアクセス権を確かめてください。</translation>
    </message>
    <message>
        <source>'{0}' cannot be read ({1}): name a JSON file of settings.</source>
        <translation>「{0}」を読み取れません（{1}）。設定の JSON ファイルを指定してください。</translation>
    </message>
    <message>
        <source>'{0}' cannot be the name of a machine: take up to 40 letters, digits, spaces and - only.</source>
        <translation>'{0}' は機械の名前に使えません。40 文字までの英数字、空白、- だけにしてください。</translation>
    </message>
    <message>
        <source>'{0}' has a column twice.</source>
        <translation>「{0}」に同じ列が 2 つあります。</translation>
    </message>
    <message>
        <source>'{0}' has another unit than {1}: write it like {2}.</source>
        <translation>「{0}」の単位は {1} に合いません。{2} のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' has its own panels: leave out what you give of gores or of a side band.</source>
        <translation>「{0}」には独自のパネルがあります。ゴアや側面の帯の指定を外してください。</translation>
    </message>
    <message>
        <source>'{0}' has its panels as they are to be cut: use inflate instead of design.</source>
        <translation>「{0}」のパネルは切る形そのものです。design の代わりに inflate を使ってください。</translation>
    </message>
    <message>
        <source>'{0}' has no closed line: give the pattern as it was cut.</source>
        <translation>「{0}」に閉じた線がありません。切ったときの型紙を渡してください。</translation>
    </message>
    <message>
        <source>'{0}' has no panels of its own: give gores, or the width of a side band.</source>
        <translation>「{0}」には独自のパネルがありません。ゴアの数か側面の帯の幅を指定してください。</translation>
    </message>
    <message>
        <source>'{0}' has no profile: give half the outline of the body as an SVG, a DXF or JSON.</source>
        <translation>「{0}」には断面がありません。立体の輪郭の半分を SVG、DXF、JSON で渡してください。</translation>
    </message>
    <message>
        <source>'{0}' has the size of its panels: leave out the width and the height.</source>
        <translation>「{0}」の大きさはパネルで決まります。幅と高さを外してください。</translation>
    </message>
    <message>
        <source>'{0}' has {1} x {2} pixels, more than {3} million. Make it smaller; 2000 pixels across are plenty.</source>
        <translation>「{0}」は {1} x {2} ピクセルで、{3} 百万を超えています。小さくしてください。幅 2000 ピクセルあれば十分です。</translation>
    </message>
    <message>
        <source>'{0}' is a body: leave out what you give of gores or of a side band.</source>
        <translation>「{0}」 は立体です。ゴアや側面の帯の指定を外してください。</translation>
    </message>
    <message>
        <source>'{0}' is a pipe or a device: save what comes from it, and name that file.</source>
        <translation>「{0}」はパイプかデバイスです。そこから来る内容をファイルに保存し、そのファイルを指定してください。</translation>
    </message>
    <message>
        <source>'{0}' is a profile, which has no side band: give a drawing for that.</source>
        <translation>「{0}」は断面で、側面の帯はありません。帯には図を渡してください。</translation>
    </message>
    <message>
        <source>'{0}' is colder than anything; write a temperature as 20C, 68F or 293K.</source>
        <translation>「{0}」は絶対零度より低い温度です。20C、68F、293K のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture ({1}). Save it as PNG, JPEG or BMP once more.</source>
        <translation>「{0}」は壊れているか、画像ではありません（{1}）。PNG、JPEG、BMP で保存し直してください。</translation>
    </message>
    <message>
        <source>'{0}' is damaged or not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>「{0}」は壊れているか、画像ではありません。PNG、JPEG、BMP で保存し直してください。</translation>
    </message>
    <message>
        <source>'{0}' is damaged. Save it as PNG, JPEG or BMP once more.</source>
        <translation>「{0}」は壊れています。PNG、JPEG、BMP で保存し直してください。</translation>
    </message>
    <message>
        <source>'{0}' is empty. Choose another file.</source>
        <translation>「{0}」は空です。別のファイルを選んでください。</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Make it simpler.</source>
        <translation>「{0}」は {1} MB を超えています。内容を簡単にしてください。</translation>
    </message>
    <message>
        <source>'{0}' is larger than {1} MB. Save it as JPEG or PNG.</source>
        <translation>「{0}」は {1} MB を超えています。JPEG か PNG で保存してください。</translation>
    </message>
    <message>
        <source>'{0}' is neither SVG, DXF nor JSON. Save the drawing as one of these.</source>
        <translation>「{0}」は SVG、DXF、JSON のどれでもありません。いずれかで保存してください。</translation>
    </message>
    <message>
        <source>'{0}' is neither yes nor no: write one of them for {1}.</source>
        <translation>「{0}」は yes でも no でもありません。{1} にはどちらかを書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no JSON ({1}{2}).</source>
        <translation>「{0}」は JSON ではありません（{1}{2}）。</translation>
    </message>
    <message>
        <source>'{0}' is no JSON object: write {"queue": ...}.</source>
        <translation>「{0}」は JSON オブジェクトではありません。{"queue": ...} のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no closed body: leave out --panels, or give an STL, OBJ, PLY, 3MF or STEP.</source>
        <translation>「{0}」は閉じた立体ではありません。--panels を外すか、STL、OBJ、PLY、3MF、STEP を渡してください。</translation>
    </message>
    <message>
        <source>'{0}' is no cluster: write one of {1}.</source>
        <translation>「{0}」というクラスターはありません。{1} のどれかを書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no command of a study: write {1} or {2}.</source>
        <translation>「{0}」はスタディのコマンドではありません。{1} か {2} と書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no difference of temperatures: write 5K, 5C or 9F.</source>
        <translation>「{0}」は温度差ではありません。5K、5C、9F のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no file: name one.</source>
        <translation>「{0}」はファイルではありません。ファイルを指定してください。</translation>
    </message>
    <message>
        <source>'{0}' is no number for {1}.</source>
        <translation>「{0}」は {1} の数として使えません。</translation>
    </message>
    <message>
        <source>'{0}' is no single value for {1}.</source>
        <translation>「{0}」は {1} の単一の値ではありません。</translation>
    </message>
    <message>
        <source>'{0}' is no size: write 500mm for a width, 500mmx700mm for width and height.</source>
        <translation>「{0}」は大きさではありません。幅だけなら 500mm、幅と高さなら 500mmx700mm のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no table ({1}): save it as CSV.</source>
        <translation>「{0}」は表ではありません（{1}）。CSV で保存してください。</translation>
    </message>
    <message>
        <source>'{0}' is no test card: name the test-card.json that was made with it.</source>
        <translation>'{0}' はテストカードではありません: 一緒に作られた test-card.json を指定してください。</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save it as one.</source>
        <translation>「{0}」は UTF-8 のテキストではありません。UTF-8 で保存してください。</translation>
    </message>
    <message>
        <source>'{0}' is no text in UTF-8: save the table as CSV in UTF-8.</source>
        <translation>「{0}」は UTF-8 のテキストではありません。表を UTF-8 の CSV で保存してください。</translation>
    </message>
    <message>
        <source>'{0}' is no value for an option of sbatch: write one line.</source>
        <translation>「{0}」は sbatch のオプションの値ではありません。1 行で書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}.</source>
        <translation>「{0}」は {1} の値ではありません。</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number and its unit.</source>
        <translation>「{0}」は {1} の値ではありません。数と単位を書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number in its unit.</source>
        <translation>「{0}」は {1} の値ではありません。その単位で数を書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no value for {1}: write a number without a unit.</source>
        <translation>「{0}」は {1} の値ではありません。単位のない数を書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no way to search: write {1} or {2}.</source>
        <translation>「{0}」という探索方法はありません。{1} か {2} と書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no way to take samples: write {1} or {2}.</source>
        <translation>「{0}」はサンプルの取り方ではありません。{1} か {2} と書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no whole number: write one for {1}.</source>
        <translation>「{0}」は整数ではありません。{1} には整数を書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is no {1}: write {2}.</source>
        <translation>「{0}」は {1} の選択肢にありません。次のどれかを書いてください：{2}。</translation>
    </message>
    <message>
        <source>'{0}' is none of {1} for {2}.</source>
        <translation>「{0}」は {2} に使える {1} のどれでもありません。</translation>
    </message>
    <message>
        <source>'{0}' is not a drawing that can be read. Use PNG, JPEG, BMP, SVG, DXF or JSON.</source>
        <translation>「{0}」は読み込める図ではありません。PNG、JPEG、BMP、SVG、DXF、JSON を使ってください。</translation>
    </message>
    <message>
        <source>'{0}' is not a file name: leave out the folder.</source>
        <translation>「{0}」はファイル名ではありません。フォルダーは書かないでください。</translation>
    </message>
    <message>
        <source>'{0}' is not a picture that can be read. Save it as PNG, JPEG or BMP.</source>
        <translation>「{0}」は読み込める画像ではありません。PNG、JPEG、BMP で保存してください。</translation>
    </message>
    <message>
        <source>'{0}' is not a temperature; write it as 20C, 68F or 293K.</source>
        <translation>「{0}」は温度ではありません。20C、68F、293K のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is not a {1}; write it like {2}.</source>
        <translation>「{0}」は使えません（{1}）。{2} のように書いてください。</translation>
    </message>
    <message>
        <source>'{0}' is read by FreeCAD, which is not there: install it for the Python that runs this, or give an STL of the solid.</source>
        <translation>「{0}」を読むのに必要な FreeCAD がありません。これを実行している Python から使えるように入れるか、ソリッドの STL を渡してください。</translation>
    </message>
    <message>
        <source>'{}' has {} x {} pixels, more than {} million. Make it smaller; 2000 across are plenty.</source>
        <translation>「{}」は {} x {} ピクセルで、{} 百万を超えています。小さくしてください。幅 2000 ピクセルあれば十分です。</translation>
    </message>
    <message>
        <source>'{}' is not a picture. Save it as PNG, JPEG or BMP once more.</source>
        <translation>「{}」は画像ではありません。PNG、JPEG、BMP で保存し直してください。</translation>
    </message>
    <message>
        <source>'{}' was painted with a newer release: update Film Balloon.</source>
        <translation>「{}」は新しい版で描かれています。Film Balloon を更新してください。</translation>
    </message>
    <message>
        <source>, about {0}</source>
        <translation>、約 {0}</translation>
    </message>
    <message>
        <source>, estimated: the film did not come to rest</source>
        <translation>、推定値：フィルムが静止しませんでした</translation>
    </message>
    <message>
        <source>, one edge must turn</source>
        <translation>（辺を折り返す継ぎ目が 1 本）</translation>
    </message>
    <message>
        <source>, {0} of them mirrored</source>
        <translation>（うち反転 {0} 枚）</translation>
    </message>
    <message>
        <source>--jobs and --timeout are numbers above 0.</source>
        <translation>--jobs と --timeout は 0 より大きい数です。</translation>
    </message>
    <message>
        <source>--oversize scale makes the balloon smaller until it fits, --oversize split writes several files between which the film is moved, --oversize write writes the file anyway, --bed tells how large the bed is.</source>
        <translation>--oversize scale は収まるまで風船を小さくし、--oversize split はフィルムを置き直しながら使う複数のファイルを書き出し、--oversize write はそのまま書き出します。加工台の大きさは --bed で指定します。</translation>
    </message>
    <message>
        <source>--rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>--rim は溶着線とその外側のフィルムを合わせた幅です。0～1 m にしてください。</translation>
    </message>
    <message>
        <source>--tabs-below is about tabs: give their width too, such as --tabs 0.4mm.</source>
        <translation>--tabs-below はタブのための値です。--tabs 0.4mm のようにタブの幅も指定してください。</translation>
    </message>
    <message>
        <source>--target-volume and --target-lift decide the size: leave out --width and --height.</source>
        <translation>大きさは --target-volume と --target-lift で決まります。--width と --height を省いてください。</translation>
    </message>
    <message>
        <source>1 to {0} pieces can be laid out, not {1}.</source>
        <translation>配置できるのは 1～{0} 枚です（{1} は不可）。</translation>
    </message>
    <message>
        <source>3D model (GLB)</source>
        <translation>3D モデル (GLB)</translation>
    </message>
    <message>
        <source>95 % below {} ({})</source>
        <translation>95 % が {} 以下（{}）</translation>
    </message>
    <message>
        <source>95 % of it below</source>
        <translation>95 % がこれ以下</translation>
    </message>
    <message>
        <source>A GIF needs Pillow: install it with pip install pillow.</source>
        <translation>GIF には Pillow が必要です。pip install pillow で入れてください。</translation>
    </message>
    <message>
        <source>A balloon has no "{0}": it has {1}.</source>
        <translation>風船に「{0}」という値はありません。使えるもの：{1}。</translation>
    </message>
    <message>
        <source>A balloon with a side band has no welds inside: its front and back are apart. Leave them out, or make it of two panels.</source>
        <translation>側面の帯のある風船には内側の溶着がありません。表と裏が離れているためです。溶着を外すか、2 枚のパネルで作ってください。</translation>
    </message>
    <message>
        <source>A bar is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>バーでは {0} は {1} で溶着するとされていますが、この工具は {2} です。頼りにする前に、テストカードをはがして確かめてください。</translation>
    </message>
    <message>
        <source>A bed is that of a machine: give --machine too.</source>
        <translation>加工台は機械のものです。--machine も指定してください。</translation>
    </message>
    <message>
        <source>A bed is {0} mm to {1} mm wide and high: write 600mmx400mm, 600mm for a roll, or {2}.</source>
        <translation>加工台の幅と高さは {0} mm～{1} mm です。600mmx400mm、ロールなら 600mm、または {2} と書いてください。</translation>
    </message>
    <message>
        <source>A bed of {0} is too small to lay so much film on anew: give a larger one, or make the balloon smaller.</source>
        <translation>{0} の加工台は、これだけのフィルムを置き直すには小さすぎます。もっと大きい加工台にするか、風船を小さくしてください。</translation>
    </message>
    <message>
        <source>A body cannot be made of {0} gores. Take {1} to {2}.</source>
        <translation>立体は {0} 枚のゴアでは作れません。{1}～{2} 枚にしてください。</translation>
    </message>
    <message>
        <source>A body has 2 panels or more: these are the last ones.</source>
        <translation>立体のパネルは 2 枚以上です。これが最後の 2 枚です。</translation>
    </message>
    <message>
        <source>A body is divided into 2 to {0} panels: say how many.</source>
        <translation>立体は 2～{0} 枚のパネルに分けます。枚数を指定してください。</translation>
    </message>
    <message>
        <source>A body of gores has no side band: leave out what you give of the one or of the other.</source>
        <translation>ゴアの立体に側面の帯はありません。どちらかの指定を外してください。</translation>
    </message>
    <message>
        <source>A closed body; a copy of it travels in the document</source>
        <translation>閉じた立体。写しが文書に入ります</translation>
    </message>
    <message>
        <source>A colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>A corner relief of {0} would cut into the weld: choose a smaller radius or a wider allowance.</source>
        <translation>{0} の角の逃げは溶着線に食い込みます。半径を小さくするか、余白を広くしてください。</translation>
    </message>
    <message>
        <source>A cow from a mesh, by Keenan Crane: change the number of panels</source>
        <translation>Keenan Crane 作のメッシュの牛：パネルの数を変えてみてください</translation>
    </message>
    <message>
        <source>A drawing with welds inside is not made symmetric: draw it so, and turn this off.</source>
        <translation>内側に溶着線のある図は対称にしません。対称に描き、この設定をオフにしてください。</translation>
    </message>
    <message>
        <source>A file of this name is there already</source>
        <translation>この名前のファイルはすでにあります</translation>
    </message>
    <message>
        <source>A film of this name is there already: else it gets the mean of all</source>
        <translation>この名前のフィルムはすでにあります。選ばなければ、すべての写真の平均になります</translation>
    </message>
    <message>
        <source>A film of your own beside the balloon's, with what was found; it changes no pattern</source>
        <translation>見つかった値を入れた自分のフィルムを、風船のフィルムとは別に作ります。型紙は変わりません</translation>
    </message>
    <message>
        <source>A fitted film is kept beside the numbers of a known one: choose the balloon's film in its panel.</source>
        <translation>合わせたフィルムは、既知のフィルムの数値に添えて残します。風船のフィルムをパネルで選んでください。</translation>
    </message>
    <message>
        <source>A fitted film is written beside the numbers of a known one: give it by --material.</source>
        <translation>合わせたフィルムは、既知のフィルムの数値とともに書き出します。そのフィルムを --material で指定してください。</translation>
    </message>
    <message>
        <source>A flat panel has no pressure and no rim: leave out --fit, --rim and --uncorrected.</source>
        <translation>平らなパネルには圧力も縁もありません。--fit、--rim、--uncorrected を外してください。</translation>
    </message>
    <message>
        <source>A goal has no '{0}': it has one of {1}, and {2}, {3} and {4}.</source>
        <translation>目標に「{0}」はありません。{1} のどれか一つと、{2}、{3}、{4} があります。</translation>
    </message>
    <message>
        <source>A goal has one of {0}: write {1}.</source>
        <translation>目標には {0} のどれか一つを書きます。{1} のように書いてください。</translation>
    </message>
    <message>
        <source>A hole meets the outline or another hole at {0}; keep some film between them.</source>
        <translation>穴が {0} で輪郭か別の穴に触れています。間にフィルムを残してください。</translation>
    </message>
    <message>
        <source>A hole would open or close: draw that part anew.</source>
        <translation>穴が開いたり閉じたりします。その部分を描き直してください。</translation>
    </message>
    <message>
        <source>A hot tip is stated to weld {0} at {1}, this tool has {2}: peel a test card before you rely on it.</source>
        <translation>熱したこて先では {0} は {1} で溶着するとされていますが、この工具は {2} です。頼りにする前に、テストカードをはがして確かめてください。</translation>
    </message>
    <message>
        <source>A known length, in pixels of the picture</source>
        <translation>分かっている長さ（画像のピクセル数）</translation>
    </message>
    <message>
        <source>A label has up to {0} letters, between 0.1 mm and 10 m high: change it.</source>
        <translation>文字は {0} 字まで、高さは 0.1 mm～10 m です。変更してください。</translation>
    </message>
    <message>
        <source>A layout is as large as its film: give the film the size of the bed there.</source>
        <translation>配置の大きさはフィルムの大きさと同じです。フィルムの大きさを加工台に合わせてください。</translation>
    </message>
    <message>
        <source>A lift of {0} cannot be made: give one such as 5g.</source>
        <translation>{0} の浮力は作れません。5g のように指定してください。</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would carry {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>{0} の浮力は得られません。{1} の大きさでも持ち上げられるのは {2} です。軽いフィルムや気体、小さな浮力、丸い形を選んでください。</translation>
    </message>
    <message>
        <source>A lift of {0} is out of reach: {1} large, this balloon would lack {2}. Choose a lighter film or gas, a smaller lift, or a rounder shape.</source>
        <translation>{0} の浮力は得られません。{1} の大きさでも {2} 足りません。軽いフィルムや気体、小さな浮力、丸い形を選んでください。</translation>
    </message>
    <message>
        <source>A line that is projected needs a direction. Give one.</source>
        <translation>投影する線には方向が必要です。指定してください。</translation>
    </message>
    <message>
        <source>A line that is projected needs two points or more. Draw them.</source>
        <translation>投影する線には 2 点以上が必要です。描いてください。</translation>
    </message>
    <message>
        <source>A mesh of {0} is too coarse for a shape of {1}: use at most {2}.</source>
        <translation>{1} の形に {0} のメッシュは粗すぎます。{2} 以下にしてください。</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for a shape of {1}: use at least {2}.</source>
        <translation>{1} の形に {0} のメッシュでは節点が 100 万を超えます。{2} 以上にしてください。</translation>
    </message>
    <message>
        <source>A mesh of {0} would need more than a million vertices for these panels: use at least {1}.</source>
        <translation>メッシュ {0} ではこのパネルに 100 万を超える節点が必要です。{1} 以上にしてください。</translation>
    </message>
    <message>
        <source>A new Sketcher sketch of lines and arcs, to go on with in FreeCAD</source>
        <translation>FreeCAD で作業を続けるための、直線と円弧の新しいスケッチ</translation>
    </message>
    <message>
        <source>A node that moves needs a place to move to; nothing else does.</source>
        <translation>移動するノードには移動先が必要です。ほかの操作では指定しません。</translation>
    </message>
    <message>
        <source>A number of an intake is empty.</source>
        <translation>注入口の数値が空です。</translation>
    </message>
    <message>
        <source>A package for this cluster is missing: {0}</source>
        <translation>このクラスターに必要なパッケージがありません：{0}</translation>
    </message>
    <message>
        <source>A passage of {0} is left open in the weld at {1}, so that air reaches both sides.</source>
        <translation>空気が両側に届くように、溶着線の {1} に {0} の通路を残しました。</translation>
    </message>
    <message>
        <source>A photograph</source>
        <translation>写真</translation>
    </message>
    <message>
        <source>A photograph on a page needs Pillow: install it with pip install pillow.</source>
        <translation>ページの写真には Pillow が要ります。pip install pillow で入れてください。</translation>
    </message>
    <message>
        <source>A picture cannot be drawn as "{0}": choose {1}.</source>
        <translation>画像の描き方「{0}」は使えません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>A picture has no size of its own. Give the width or the height of the balloon.</source>
        <translation>画像には寸法がありません。風船の幅か高さを入力してください。</translation>
    </message>
    <message>
        <source>A picture that covers what is behind the balloon, such as a photograph of a room</source>
        <translation>風船の後ろを覆う画像、部屋の写真など</translation>
    </message>
    <message>
        <source>A piece does not fit on the sheet: take a larger one.</source>
        <translation>部品がシートに収まりません。大きなシートを使ってください。</translation>
    </message>
    <message>
        <source>A piece of {0} x {1} does not fit on film of {2}{3}: take film at least {4} wide, or let the grain lie in another direction.</source>
        <translation>{0} x {1} の部品は {2}{3} のフィルムに収まりません。幅 {4} 以上のフィルムを使うか、流れ方向を変えてください。</translation>
    </message>
    <message>
        <source>A pillow box cannot be deeper than wide. Choose a smaller depth.</source>
        <translation>枕箱の奥行きは幅より大きくできません。奥行きを小さくしてください。</translation>
    </message>
    <message>
        <source>A plane needs its normal. Give one.</source>
        <translation>平面には法線が必要です。指定してください。</translation>
    </message>
    <message>
        <source>A print is not cut in parts: choose a machine with a larger bed than {0}, or make the balloon smaller.</source>
        <translation>印刷は分割して切れません。{0} より大きい加工台の機械を選ぶか、風船を小さくしてください。</translation>
    </message>
    <message>
        <source>A process beside this one does not start: {0}</source>
        <translation>別のプロセスが起動しません：{0}</translation>
    </message>
    <message>
        <source>A process beside this one is of version {0}, not of {1}: install one of them anew.</source>
        <translation>別のプロセスの版が {1} ではなく {0} です。どちらかを入れ直してください。</translation>
    </message>
    <message>
        <source>A remnant is left of a layout: give --nest too, such as --nest 500mm.</source>
        <translation>残材は配置から残るものです。--nest 500mm のように --nest も指定してください。</translation>
    </message>
    <message>
        <source>A script needs to know how many shards it has: give --shards a number.</source>
        <translation>スクリプトには分割の数が必要です。--shards に数を指定してください。</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: it would meet another one.</source>
        <translation>継ぎ目をそこまで動かせません。別の継ぎ目に当たります。</translation>
    </message>
    <message>
        <source>A seam cannot be moved so far: one of its panels would be lost.</source>
        <translation>継ぎ目をそこまで動かせません。両側のパネルの 1 枚がなくなります。</translation>
    </message>
    <message>
        <source>A seam closes an edge of a triangle to a point. Check which runs it joins.</source>
        <translation>継ぎ目が三角形の辺を一点に閉じています。どの区間をつなぐのかを確認してください。</translation>
    </message>
    <message>
        <source>A seam near {0} has one place only. Draw it through two.</source>
        <translation>{0} 付近の継ぎ目の位置が 1 つしかありません。2 つの位置を通して描いてください。</translation>
    </message>
    <message>
        <source>A seam near {0} would pass the same place twice. Draw it in two parts.</source>
        <translation>{0} 付近の継ぎ目が同じ所を 2 回通ります。2 つに分けて描いてください。</translation>
    </message>
    <message>
        <source>A separating layer of PTFE gives off poisonous fumes above {0}, and baking paper chars above {1}: weld slower at a lower temperature, and air the room.</source>
        <translation>間に敷く PTFE は {0} を超えると有毒な煙を出し、クッキングシートは {1} を超えると焦げます。温度を下げてゆっくり溶着し、部屋を換気してください。</translation>
    </message>
    <message>
        <source>A setting is tried with up to twelve values, each once.</source>
        <translation>一つの設定は最大 12 個の値で、それぞれ一度だけ試します。</translation>
    </message>
    <message>
        <source>A sketch with dimensions: change a cell of the spreadsheet, and all follows</source>
        <translation>寸法付きのスケッチ：表のセルを変えると全体が追従します</translation>
    </message>
    <message>
        <source>A spread of {0} % leaves nothing of the {1}: give {2} at most {3} %.</source>
        <translation>{0} % のばらつきでは何も残りません（{1}）。{2} は {3} % 以下にしてください。</translation>
    </message>
    <message>
        <source>A strict reader that wants plain polylines. Layers are told apart by colour: cut red, blue and orange, set the output of all others to no.</source>
        <translation>単純なポリラインだけを読む厳格なプログラムです。レイヤーは色で区別されます。赤、青、オレンジを切り、ほかの色はすべて出力を「なし」にしてください。</translation>
    </message>
    <message>
        <source>A study has no '{0}': it has {1} and {2}.</source>
        <translation>スタディに「{0}」はありません。{1} と {2} があります。</translation>
    </message>
    <message>
        <source>A study of tolerances is about one balloon: give {0} a single value.</source>
        <translation>公差のスタディは 1 つの風船についてのものです。{0} に値を 1 つだけ指定してください。</translation>
    </message>
    <message>
        <source>A study of tolerances says what strays, such as {"cut": {"normal": "0.2mm"}}.</source>
        <translation>公差のスタディには、ばらつくものを書きます。例：{"cut": {"normal": "0.2mm"}}。</translation>
    </message>
    <message>
        <source>A study of tolerances takes 1 to {0} samples, not {1}: {2} tell a lot.</source>
        <translation>公差のスタディのサンプルは {1} ではなく、1 から {0} までです。{2} で十分に分かります。</translation>
    </message>
    <message>
        <source>A tab must be {0} to {1} wide, not {2}; 0 makes none.</source>
        <translation>タブの幅は {0}～{1} です（指定は {2}）。0 ならタブなしです。</translation>
    </message>
    <message>
        <source>A test card is for a machine, in a folder: give --machine and --out.</source>
        <translation>テストカードには機械とフォルダーが必要です: --machine と --out を指定してください。</translation>
    </message>
    <message>
        <source>A test card tries one or two settings: give several values of them, such as 200,300,400.</source>
        <translation>テストカードは一つか二つの設定を試します: 200,300,400 のように複数の値を指定してください。</translation>
    </message>
    <message>
        <source>A tool has no "{0}": choose one of {1}.</source>
        <translation>工具に "{0}" はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>A tool is that of a machine that reads G-code: give --machine gcode-grbl or another.</source>
        <translation>工具は G コードを読む機械のものです。--machine gcode-grbl などを指定してください。</translation>
    </message>
    <message>
        <source>A tool that an axis turns does not swivel behind it: set knife_offset_mm to 0, or leave turning_axis out.</source>
        <translation>軸が回す工具は、軸に遅れて自在に回ることはありません。knife_offset_mm を 0 にするか、turning_axis を外してください。</translation>
    </message>
    <message>
        <source>A volume of {0} cannot be made: give one such as 10l.</source>
        <translation>{0} の体積は作れません。10l のように指定してください。</translation>
    </message>
    <message>
        <source>A volume or a lift decides the size, so the balloon cannot be scaled to fit: leave out --oversize scale, or what you give of --target-volume, --target-lift and --gas-volume.</source>
        <translation>大きさは体積か浮力で決まるため、風船を収まるように縮められません。--oversize scale か、指定した --target-volume、--target-lift、--gas-volume を省いてください。</translation>
    </message>
    <message>
        <source>A volume to inflate to and a goal for the size exclude each other: leave one out.</source>
        <translation>ふくらませる体積と大きさの目標は同時に指定できません。どちらかを外してください。</translation>
    </message>
    <message>
        <source>A web page came instead of the native solver, as some networks send before one has signed in. Open {0} in a browser, then try again. {1}</source>
        <translation>ネイティブソルバーではなく Web ページが届きました。サインインするまでこうなるネットワークがあります。ブラウザーで {0} を開いてから、もう一度試してください。{1}</translation>
    </message>
    <message>
        <source>A weld has no length; draw a line, or a circle for a spot.</source>
        <translation>溶着線に長さがありません。線か、点なら円を描いてください。</translation>
    </message>
    <message>
        <source>A weld leaves the film at {0}; keep it inside.</source>
        <translation>溶着線が {0} でフィルムの外に出ています。内側に収めてください。</translation>
    </message>
    <message>
        <source>A weld meets the outline, itself or another weld at {0}; keep some film between them.</source>
        <translation>溶着線が {0} で輪郭、自分自身、または別の溶着線に触れています。間にフィルムを残してください。</translation>
    </message>
    <message>
        <source>A weld runs too near to another one or to the outline at {0} for this mesh: move it away, or use a smaller mesh size.</source>
        <translation>{0} で溶着線が別の溶着線か輪郭に近すぎて、このメッシュでは扱えません。離すか、メッシュを細かくしてください。</translation>
    </message>
    <message>
        <source>A weld that crumples can be simulated of one panel and its mirror image alone: choose the elastic weld, or one panel and its mirror image.</source>
        <translation>しわの寄る溶着線を計算できるのは、1 枚とその鏡像の場合だけです。弾性の溶着線にするか、1 枚とその鏡像にしてください。</translation>
    </message>
    <message>
        <source>A worker does not have this program ({0}): install it everywhere.</source>
        <translation>このプログラムのないワーカーがあります（{0}）。すべてに入れてください。</translation>
    </message>
    <message>
        <source>A worker of Dask failed ({0}: {1}).</source>
        <translation>Dask のワーカーが失敗しました（{0}: {1}）。</translation>
    </message>
    <message>
        <source>A {0} of {1} cannot be made; choose one between 1 mm and 100 m.</source>
        <translation>{0} {1} は作れません。1 mm～100 m にしてください。</translation>
    </message>
    <message>
        <source>About {} thick</source>
        <translation>厚さ約 {}</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>直角</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>助言</translation>
    </message>
    <message>
        <source>Advice ({0}), at {1}: {2}</source>
        <translation>助言（{0}）、{1}：{2}</translation>
    </message>
    <message>
        <source>Advice on many panels is measured on the balloon: inflate it first.</source>
        <translation>複数パネルの助言は風船で測ります。先にふくらませてください。</translation>
    </message>
    <message>
        <source>Air intake</source>
        <translation>注入口</translation>
    </message>
    <message>
        <source>Airship</source>
        <translation>飛行船</translation>
    </message>
    <message>
        <source>All packages are installed.</source>
        <translation>必要なパッケージはすべてそろっています。</translation>
    </message>
    <message>
        <source>All panels are on the sheet once: none is drawn a second time, mirrored.</source>
        <translation>すべてのパネルはシートに 1 回だけ載ります。反転してもう一度描かれるものはありません。</translation>
    </message>
    <message>
        <source>All points of the mesh are in one place. Save the body as a mesh of triangles.</source>
        <translation>メッシュの点がすべて同じ場所にあります。立体を三角形のメッシュとして保存してください。</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>外側の余白</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>平行</translation>
    </message>
    <message>
        <source>Along the seam</source>
        <translation>溶着線に沿った長さ</translation>
    </message>
    <message>
        <source>Also on the other side</source>
        <translation>反対側にも</translation>
    </message>
    <message>
        <source>Aluminised BOPP foil, 30 µm</source>
        <translation>アルミ蒸着 BOPP フィルム、30 µm</translation>
    </message>
    <message>
        <source>Aluminised PET ("Mylar"), 25 µm</source>
        <translation>アルミ蒸着 PET（マイラー）、25 µm</translation>
    </message>
    <message>
        <source>Aluminised nylon/PE foil (party balloon), 30 µm</source>
        <translation>アルミ蒸着ナイロン/PE フィルム（パーティー用風船）、30 µm</translation>
    </message>
    <message>
        <source>An accuracy is for a balloon that follows its body: give the number of panels of one that encloses or lines it.</source>
        <translation>精度を指定できるのは立体に沿う風船だけです。立体を包む風船や内側に張る風船では、パネルの数を指定してください。</translation>
    </message>
    <message>
        <source>An animation needs at least two frames, not {0}.</source>
        <translation>アニメーションには 2 コマ以上必要です（指定は {0}）。</translation>
    </message>
    <message>
        <source>An intake of {0} does not reach past the cut: give it at least {1}.</source>
        <translation>{0} の注入口は切り線の外まで届きません。{1} 以上にしてください。</translation>
    </message>
    <message>
        <source>An outline cannot be edited by "{0}": choose one of {1}.</source>
        <translation>輪郭を「{0}」で編集することはできません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>An outline keeps three nodes: move them instead.</source>
        <translation>輪郭にはノードが 3 つ必要です。消さずに動かしてください。</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Animate inflation</source>
        <translation>膨張のアニメーション</translation>
    </message>
    <message>
        <source>Another study is running in '{0}': wait for it, or choose another folder.</source>
        <translation>「{0}」で別のスタディが実行中です。終わるのを待つか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>Any colour</source>
        <translation>好きな色</translation>
    </message>
    <message>
        <source>Any colour (K)</source>
        <translation>好きな色（K）</translation>
    </message>
    <message>
        <source>Any program (DXF)</source>
        <translation>任意のプログラム（DXF）</translation>
    </message>
    <message>
        <source>Any program (SVG)</source>
        <translation>任意のプログラム（SVG）</translation>
    </message>
    <message>
        <source>Any size</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>適用</translation>
    </message>
    <message>
        <source>Arcs in a sketch, as they hang over a party table</source>
        <translation>パーティーの飾りのような、スケッチの円弧でできた文字</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>Arm too thin to fill</source>
        <translation>細すぎてふくらまない腕</translation>
    </message>
    <message>
        <source>Artwork</source>
        <translation>絵柄</translation>
    </message>
    <message>
        <source>As Summa with OPOS, and the bar between the lower squares shows the cutter whether the print is bent. Feed the sheet with the bar first. The layer Regmark is not cut.</source>
        <translation>「OPOS 付き Summa」と同じですが、下の四角の間の棒で印刷のゆがみも読み取ります。棒のある側から先にシートを送ってください。レイヤー Regmark は切りません。</translation>
    </message>
    <message>
        <source>As at first</source>
        <translation>最初に戻す</translation>
    </message>
    <message>
        <source>As made</source>
        <translation>できたまま</translation>
    </message>
    <message>
        <source>As made over what was expected</source>
        <translation>実物と予想の重ね合わせ</translation>
    </message>
    <message>
        <source>As made: {0}, expected: {1}</source>
        <translation>実物：{0}、予想：{1}</translation>
    </message>
    <message>
        <source>Assembly sheet</source>
        <translation>組み立て図</translation>
    </message>
    <message>
        <source>Assembly sheet written to {}</source>
        <translation>組み立て図を {} に書き出しました</translation>
    </message>
    <message>
        <source>At least 95 of 100 balloons bear {0} with their margin, by {1} samples and with a confidence of 95 %.</source>
        <translation>100 個の風船のうち少なくとも 95 個が、余裕を保って {0} に耐えます（サンプル {1}、信頼度 95 %）。</translation>
    </message>
    <message>
        <source>At work the {0} is {1} above the film, and lifted {2} only: give it more depth, or a higher lift_mm.</source>
        <translation>作業中の工具（{0}）はフィルムの {1} 上にあり、上げた高さは {2} しかありません。深さを増やすか、lift_mm を大きくしてください。</translation>
    </message>
    <message>
        <source>At worst the film lies {0} on the wrong side of the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>フィルムは最大 {0} 立体の反対側にあり、指定された余裕は {1} です。パネルを増やすか、余裕を大きくしてください。</translation>
    </message>
    <message>
        <source>At {0} dots per inch the sheet would have {1} x {2} pixels: give a lower resolution.</source>
        <translation>{0} dpi ではシートが {1} x {2} ピクセルになります。解像度を下げてください。</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>軸</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>裏</translation>
    </message>
    <message>
        <source>Bag</source>
        <translation>袋</translation>
    </message>
    <message>
        <source>Bag of panels</source>
        <translation>パネルの袋</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>風船</translation>
    </message>
    <message>
        <source>Balloon as a GLB file, for 3D programs</source>
        <translation>風船の GLB ファイル（3D プログラム用）</translation>
    </message>
    <message>
        <source>Balloon film</source>
        <translation>風船のフィルム</translation>
    </message>
    <message>
        <source>Balloon of row {0}</source>
        <translation>{0} 行の風船</translation>
    </message>
    <message>
        <source>Balloon pattern</source>
        <translation>風船の型紙</translation>
    </message>
    <message>
        <source>Balloon: {0}, {1}, solver {2}</source>
        <translation>風船：{0}、{1}、ソルバー {2}</translation>
    </message>
    <message>
        <source>Balloons</source>
        <translation>風船</translation>
    </message>
    <message>
        <source>Balloons of each</source>
        <translation>それぞれの個数</translation>
    </message>
    <message>
        <source>Balloons: {0}, of these are there: {1}</source>
        <translation>風船：{0}、うち作成済み：{1}</translation>
    </message>
    <message>
        <source>Balloons: {0}, worked out now: {1}, of these failed: {2}</source>
        <translation>風船：{0}、今回計算：{1}、うち失敗：{2}</translation>
    </message>
    <message>
        <source>Bar of 100 mm to measure</source>
        <translation>測って確かめる 100 mm の棒</translation>
    </message>
    <message>
        <source>Bed</source>
        <translation>加工台</translation>
    </message>
    <message>
        <source>Before it is written</source>
        <translation>書き出す前に</translation>
    </message>
    <message>
        <source>Bending stiffness</source>
        <translation>曲げ剛性</translation>
    </message>
    <message>
        <source>Beside the document</source>
        <translation>文書と同じ場所</translation>
    </message>
    <message>
        <source>Beside the pattern, to see whether the size was kept</source>
        <translation>大きさが保たれたかを見るため、型紙の横に入れます</translation>
    </message>
    <message>
        <source>Best field</source>
        <translation>最も良い欄</translation>
    </message>
    <message>
        <source>Best of {0} balloons: {1}, with {2}.</source>
        <translation>{0} 個の風船のうち最良：{1}、{2}。</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>黒</translation>
    </message>
    <message>
        <source>Bleed</source>
        <translation>塗り足し</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Blue 0, green {}, red {}</source>
        <translation>青 0、緑 {}、赤 {}</translation>
    </message>
    <message>
        <source>Bodies</source>
        <translation>立体</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>立体</translation>
    </message>
    <message>
        <source>Both halves of the body are made alike: they differ by {0} at most.</source>
        <translation>立体の両半分を同じ形にしました。違いは最大で {0} です。</translation>
    </message>
    <message>
        <source>Both panels</source>
        <translation>表裏 2 枚</translation>
    </message>
    <message>
        <source>Both panels are on the sheet: only the front one gets the hole of the nozzle. Cut it once.</source>
        <translation>シートには 2 枚とも並んでいます。ノズルの穴は表側だけなので、1 回だけ切ってください。</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>両側</translation>
    </message>
    <message>
        <source>Both sides of a seam must be equally long</source>
        <translation>継ぎ目の両側は同じ長さでなければなりません</translation>
    </message>
    <message>
        <source>Bottle</source>
        <translation>ボトル</translation>
    </message>
    <message>
        <source>Bring the 3D view of the document to the front first.</source>
        <translation>先に文書の 3D ビューを前面に出してください。</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>By at least</source>
        <translation>最小の間隔</translation>
    </message>
    <message>
        <source>Cannot read '{0}' ({1}): name the file of a test card.</source>
        <translation>'{0}' を読み込めません ({1}): テストカードのファイルを指定してください。</translation>
    </message>
    <message>
        <source>Cannot write to '{0}' ({1}): choose another folder for the study.</source>
        <translation>「{0}」に書き込めません（{1}）。スタディには別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>Cannot write to {0}: {1}. Choose another folder, or make room there.</source>
        <translation>{0} に書き込めません：{1}。別のフォルダーを選ぶか、空きを作ってください。</translation>
    </message>
    <message>
        <source>Cannot write {0}: {1}. Make room there and start the study again; no balloon is lost.</source>
        <translation>{0} を書き込めません：{1}。空きを作ってスタディをもう一度始めてください。計算済みの風船は残ります。</translation>
    </message>
    <message>
        <source>Card</source>
        <translation>カード</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>Check the size: the 100 mm bar on the cut file or print must measure 100 mm.</source>
        <translation>大きさの確認：カット用ファイルや印刷物にある 100 mm の棒を測り、100 mm あることを確かめます。</translation>
    </message>
    <message>
        <source>Check, {0}: {1}</source>
        <translation>確認（{0}）：{1}</translation>
    </message>
    <message>
        <source>Check: {0}</source>
        <translation>確認：{0}</translation>
    </message>
    <message>
        <source>Checked: ready to make.</source>
        <translation>確認済み：作れます。</translation>
    </message>
    <message>
        <source>Checking the pattern</source>
        <translation>型紙を確かめています</translation>
    </message>
    <message>
        <source>Choose a body</source>
        <translation>立体を選んでください</translation>
    </message>
    <message>
        <source>Choose a colour</source>
        <translation>色を選ぶ</translation>
    </message>
    <message>
        <source>Choose a drawing</source>
        <translation>図を選ぶ</translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation>ファイルを選ぶ</translation>
    </message>
    <message>
        <source>Choose a folder</source>
        <translation>フォルダーを選ぶ</translation>
    </message>
    <message>
        <source>Choose a material card</source>
        <translation>材料カードを選ぶ</translation>
    </message>
    <message>
        <source>Choose a photograph first: a PNG, JPEG or BMP file.</source>
        <translation>先に写真を選んでください（PNG、JPEG、BMP のファイル）。</translation>
    </message>
    <message>
        <source>Choose a picture</source>
        <translation>画像を選ぶ</translation>
    </message>
    <message>
        <source>Choose a picture or a sketch.</source>
        <translation>画像かスケッチを選んでください。</translation>
    </message>
    <message>
        <source>Choose a remnant</source>
        <translation>残材を選ぶ</translation>
    </message>
    <message>
        <source>Choose a row first.</source>
        <translation>先に行を選んでください。</translation>
    </message>
    <message>
        <source>Choose a sketch or a file with half the outline.</source>
        <translation>輪郭の半分のスケッチかファイルを選んでください。</translation>
    </message>
    <message>
        <source>Choose a solid, a mesh or a file with one.</source>
        <translation>ソリッド、メッシュ、またはそれを含むファイルを選んでください。</translation>
    </message>
    <message>
        <source>Choose a test card</source>
        <translation>テストカードを選ぶ</translation>
    </message>
    <message>
        <source>Choose sketches, a file or a ready body.</source>
        <translation>スケッチ、ファイル、または既製の立体を選んでください。</translation>
    </message>
    <message>
        <source>Choose the balloon that it belongs to.</source>
        <translation>対応する風船を選んでください。</translation>
    </message>
    <message>
        <source>Choose the outline to inflate.</source>
        <translation>ふくらませる輪郭を選んでください。</translation>
    </message>
    <message>
        <source>Choose the pattern to print on.</source>
        <translation>印刷する型紙を選んでください。</translation>
    </message>
    <message>
        <source>Choose the patterns to lay out.</source>
        <translation>並べる型紙を選んでください。</translation>
    </message>
    <message>
        <source>Choose the photograph that is behind the balloon.</source>
        <translation>風船の後ろに置く写真を選んでください。</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>まる</translation>
    </message>
    <message>
        <source>Click a seam: its panels become one. Esc: done.</source>
        <translation>継ぎ目をクリックすると、両側のパネルが 1 枚になります。Esc：終了。</translation>
    </message>
    <message>
        <source>Click a seam: the panels beside it become one</source>
        <translation>継ぎ目をクリックすると、両側のパネルが 1 枚になります</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to, drag a piece to move it.</source>
        <translation>辺をクリックすると、どの辺とシールするかが分かります。部品はドラッグで動かせます。</translation>
    </message>
    <message>
        <source>Click an edge to see what it is sealed to.</source>
        <translation>辺をクリックすると、どの辺とシールするかが分かります。</translation>
    </message>
    <message>
        <source>Click and type; pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>クリックして入力します。引いて動かし、角で大きさを変え、輪で回します。Enter で描き、Esc でやめます。</translation>
    </message>
    <message>
        <source>Click both ends of a length that you know; a third click moves the nearer mark.</source>
        <translation>分かっている長さの両端をクリックします。3 回目のクリックは近い方の印を動かします。</translation>
    </message>
    <message>
        <source>Click both ends of a ruler in the picture, or of another known length</source>
        <translation>画像の中の定規など、長さの分かるものの両端をクリックします</translation>
    </message>
    <message>
        <source>Click on the paper, then type</source>
        <translation>紙をクリックして入力</translation>
    </message>
    <message>
        <source>Click the line for a new node; drag nodes; Delete removes them; S: sharp or round.</source>
        <translation>線をクリックするとノードが増えます。ノードはドラッグで動かし、Delete で消します。S：角か丸か。</translation>
    </message>
    <message>
        <source>Click to see it larger</source>
        <translation>クリックすると大きく表示します</translation>
    </message>
    <message>
        <source>Click two places: a seam runs between them</source>
        <translation>2 か所をクリックすると、その間に継ぎ目が通ります</translation>
    </message>
    <message>
        <source>Click two points to measure between them.</source>
        <translation>二つの点をクリックすると、その間を測ります。</translation>
    </message>
    <message>
        <source>Click where the new seam begins. Esc: done.</source>
        <translation>新しい継ぎ目の始点をクリックします。Esc：終了。</translation>
    </message>
    <message>
        <source>Click where the seam ends. Esc: another start.</source>
        <translation>継ぎ目の終点をクリックします。Esc：始点をやり直す。</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>先に開いているタスクパネルを閉じてください。</translation>
    </message>
    <message>
        <source>Cloud</source>
        <translation>雲</translation>
    </message>
    <message>
        <source>Colour map</source>
        <translation>カラーマップ</translation>
    </message>
    <message>
        <source>Colour {}</source>
        <translation>色 {}</translation>
    </message>
    <message>
        <source>Columns from the left: {0}</source>
        <translation>左からの列: {0}</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比べる</translation>
    </message>
    <message>
        <source>Compare with a photograph</source>
        <translation>写真と比べる</translation>
    </message>
    <message>
        <source>Comparing with the photograph</source>
        <translation>写真と比べています</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>比べています…</translation>
    </message>
    <message>
        <source>Coordinates really are inches, and the header says so.</source>
        <translation>座標は本当にインチで、ヘッダーにもそう書かれています。</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>枚数</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>コピー（Ctrl+C）</translation>
    </message>
    <message>
        <source>Corner relief</source>
        <translation>角の逃げ</translation>
    </message>
    <message>
        <source>Cricut Design Space</source>
        <translation>Cricut Design Space</translation>
    </message>
    <message>
        <source>Crosses, by eye</source>
        <translation>十字（目で合わせる）</translation>
    </message>
    <message>
        <source>Crumpled</source>
        <translation>しわ寄り</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>カスタム</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切る</translation>
    </message>
    <message>
        <source>Cut (Ctrl+X)</source>
        <translation>切り取り（Ctrl+X）</translation>
    </message>
    <message>
        <source>Cut all panels from {film}, as they are drawn: so they are seen from outside, with the sealing side below.</source>
        <translation>すべてのパネルを {film} から図のとおりに切ります。図は外から見た向きで、シール面が下です。</translation>
    </message>
    <message>
        <source>Cut all panels from {film}. As they are drawn they are seen from outside.</source>
        <translation>すべてのパネルを {film} から切ります。図は外から見た向きです。</translation>
    </message>
    <message>
        <source>Cut each page along its left and lower crosses, lay it on the crosses of its neighbours, tape.</source>
        <translation>各ページを左と下の十字に沿って切り、隣のページの十字に重ねてテープで留めます。</translation>
    </message>
    <message>
        <source>Cut out the hole of the nozzle, in the front panel only.</source>
        <translation>ノズルの穴を、表側のフィルムだけに切り抜きます。</translation>
    </message>
    <message>
        <source>Cut out the holes inside.</source>
        <translation>内側の穴を切り抜きます。</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored, so that the sealing sides face each other.</source>
        <translation>フィルムを 2 枚切ります（{film}）。シール面が向かい合うように、2 枚目は反転します。</translation>
    </message>
    <message>
        <source>Cut two panels from {film}, the second one mirrored.</source>
        <translation>2 枚切ります（{film}）。2 枚目は反転します。</translation>
    </message>
    <message>
        <source>Cuts without room for two tabs of {0} on a straight: {1}, the first near {2}. What they go round comes free.</source>
        <translation>まっすぐな部分に {0} のタブを 2 つ付ける余地のない切り線：{1} 本（最初は {2} 付近）。その内側は外れて落ちます。</translation>
    </message>
    <message>
        <source>Cutting shop (DXF R12)</source>
        <translation>カット業者（DXF R12）</translation>
    </message>
    <message>
        <source>Cutting shop in inches (DXF R2000)</source>
        <translation>カット業者、インチ（DXF R2000）</translation>
    </message>
    <message>
        <source>DXF files can be neither read nor written without it; SVG files can.</source>
        <translation>これがないと DXF ファイルは読み書きできません。SVG は使えます。</translation>
    </message>
    <message>
        <source>DXF files need the Python package ezdxf. Install it with 'pip install ezdxf', or save the drawing as SVG.</source>
        <translation>DXF ファイルには Python パッケージ ezdxf が必要です。「pip install ezdxf」で入れるか、図を SVG で保存してください。</translation>
    </message>
    <message>
        <source>Decoration</source>
        <translation>かざり</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Delete it</source>
        <translation>削除する</translation>
    </message>
    <message>
        <source>Delete {}? Its file goes for good.</source>
        <translation>{} を削除しますか？ ファイルは元に戻せません。</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Diameter {}, height {}, gores {} long</source>
        <translation>直径 {}、高さ {}、ゴアの長さ {}</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>Disc</source>
        <translation>円板</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>Distance from profile, drawing or body</source>
        <translation>断面、図、立体との隔たり</translation>
    </message>
    <message>
        <source>Distance {}, across {}, up {}</source>
        <translation>距離 {}、横 {}、縦 {}</translation>
    </message>
    <message>
        <source>Dividing a body needs scipy: install it with pip install scipy.</source>
        <translation>立体の分割には scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完了</translation>
    </message>
    <message>
        <source>Done (Esc)</source>
        <translation>完了 (Esc)</translation>
    </message>
    <message>
        <source>Dots per inch</source>
        <translation>解像度（dpi）</translation>
    </message>
    <message>
        <source>Double-click a row to see its balloon</source>
        <translation>行をダブルクリックするとその風船が見えます</translation>
    </message>
    <message>
        <source>Drag a seam to where it shall run. Esc: done.</source>
        <translation>継ぎ目を通したい所へドラッグします。Esc：終了。</translation>
    </message>
    <message>
        <source>Drag a seam: it runs through the place</source>
        <translation>継ぎ目をドラッグすると、その位置を通ります</translation>
    </message>
    <message>
        <source>Drag in the view</source>
        <translation>ビューでドラッグ</translation>
    </message>
    <message>
        <source>Drag to turn, turn the wheel to zoom; keys: arrows, plus, minus, Home.</source>
        <translation>ドラッグで回転、ホイールで拡大縮小。キー：矢印、＋、－、Home。</translation>
    </message>
    <message>
        <source>Draw a closed line, or paint an area: it becomes a balloon.</source>
        <translation>閉じた線を描くか、面を塗ってください。風船になります。</translation>
    </message>
    <message>
        <source>Draw half of the outline, and its axis as a straight upright line on its left.</source>
        <translation>輪郭の半分を描き、その左に軸をまっすぐ縦の線で描いてください。</translation>
    </message>
    <message>
        <source>Draw lines. A closed line becomes a balloon.</source>
        <translation>線を描きます。閉じた線は風船になります。</translation>
    </message>
    <message>
        <source>Drawing and silhouette</source>
        <translation>図とシルエット</translation>
    </message>
    <message>
        <source>Drawing over silhouette</source>
        <translation>図をシルエットに重ねる</translation>
    </message>
    <message>
        <source>Drawing seams needs scipy: install it with pip install scipy.</source>
        <translation>継ぎ目を描くには scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Drawing {0}</source>
        <translation>{0} を描いています</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>図</translation>
    </message>
    <message>
        <source>Drawn as</source>
        <translation>描き方</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>しずく</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>待ち時間</translation>
    </message>
    <message>
        <source>E across the grain</source>
        <translation>流れに直角のヤング率</translation>
    </message>
    <message>
        <source>Each row of the table once with each of these values</source>
        <translation>表の各行を、これらの値のそれぞれと 1 回ずつ組み合わせます</translation>
    </message>
    <message>
        <source>Each stroke colour becomes an operation of its own: cut red, blue and orange, set all others to ignore. DXF is not read.</source>
        <translation>線の色ごとに別の加工になります。赤、青、オレンジを切り、ほかはすべて「無視」にしてください。DXF は読めません。</translation>
    </message>
    <message>
        <source>Edges of the mesh at which more than two triangles meet: {0}, one of them at ({1}) of the mesh. Repair it in the program that it comes from, so that it is the surface of a solid.</source>
        <translation>3 つ以上の三角形が集まるメッシュの辺：{0}、その 1 つの位置はメッシュの ({1})。元のプログラムで直し、ソリッドの表面になるようにしてください。</translation>
    </message>
    <message>
        <source>Edges of the panels</source>
        <translation>パネルの縁</translation>
    </message>
    <message>
        <source>Edit artwork</source>
        <translation>絵柄を編集</translation>
    </message>
    <message>
        <source>Edit balloon</source>
        <translation>風船を編集</translation>
    </message>
    <message>
        <source>Edit film</source>
        <translation>フィルムの配置を編集</translation>
    </message>
    <message>
        <source>Edit outline</source>
        <translation>輪郭を編集</translation>
    </message>
    <message>
        <source>Edit outline ...</source>
        <translation>輪郭を編集 ...</translation>
    </message>
    <message>
        <source>Edit study</source>
        <translation>スタディを編集</translation>
    </message>
    <message>
        <source>Eight panels for a solid with fillets: change its section or their number</source>
        <translation>フィレット付きソリッドの 8 枚のパネル：断面や枚数を変えてみてください</translation>
    </message>
    <message>
        <source>Elastic</source>
        <translation>弾性</translation>
    </message>
    <message>
        <source>Elastic materials</source>
        <translation>弾性材料</translation>
    </message>
    <message>
        <source>Encloses it</source>
        <translation>立体を包む</translation>
    </message>
    <message>
        <source>Eraser</source>
        <translation>消しゴム</translation>
    </message>
    <message>
        <source>Errors as large as these leave no panel: give smaller ones.</source>
        <translation>誤差が大きすぎてパネルが残りません。小さくしてください。</translation>
    </message>
    <message>
        <source>Errors of {0} stay alike over a length above 0, such as 50mm.</source>
        <translation>{0} の誤差が似たままの長さは 0 より大きくします。例：50mm。</translation>
    </message>
    <message>
        <source>Errors that stay alike over {0} alone are too fine for a seam of {1}: give at least {2} as 'along'.</source>
        <translation>{0} しか似たままでない誤差は、長さ {1} の継ぎ目には細かすぎます。「along」を {2} 以上にしてください。</translation>
    </message>
    <message>
        <source>Every layer becomes a colour of the cut list; layers that share a colour would be merged. Set the import unit to millimetres. Cut red, blue and orange only and switch the output of all others off; the LightBurn project has them on tool layers already.</source>
        <translation>レイヤーごとにカットリストの色になり、同じ色のレイヤーはまとめられます。読み込み単位をミリメートルにしてください。切るのは赤、青、オレンジだけにし、ほかはすべて出力をオフにします。LightBurn プロジェクトなら、それらは初めからツールレイヤーにあります。</translation>
    </message>
    <message>
        <source>Expected thickness</source>
        <translation>予想される厚み</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出し</translation>
    </message>
    <message>
        <source>Export begins with it</source>
        <translation>書き出しの最初の機械にする</translation>
    </message>
    <message>
        <source>Export for the web</source>
        <translation>ウェブ用に書き出す</translation>
    </message>
    <message>
        <source>Export pattern</source>
        <translation>型紙を書き出す</translation>
    </message>
    <message>
        <source>Export pattern begins with this machine; it is a preference</source>
        <translation>「型紙を書き出す」がこの機械で始まります。これは設定に保存されます</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>式</translation>
    </message>
    <message>
        <source>Face{0} of {1} is curved so much that it would take {2} strips of film. Give a number of panels, or leave such details out of the solid.</source>
        <translation>{1} の Face{0} は曲がりが強く、フィルムの帯が {2} 本必要になります。パネルの数を指定するか、そのような細部をソリッドから除いてください。</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失敗</translation>
    </message>
    <message>
        <source>Farthest off near {0}</source>
        <translation>最も離れている所：{0} 付近</translation>
    </message>
    <message>
        <source>Farthest point</source>
        <translation>最も遠い所</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>送り速度</translation>
    </message>
    <message>
        <source>Feed in corners</source>
        <translation>角での送り速度</translation>
    </message>
    <message>
        <source>Fetch</source>
        <translation>取得する</translation>
    </message>
    <message>
        <source>Fetch the native solver ...</source>
        <translation>ネイティブソルバーを取得…</translation>
    </message>
    <message>
        <source>Fetches the native solver of this version, checks its SHA-256 and puts it in its place.</source>
        <translation>この版のネイティブソルバーを取得し、SHA-256 を確かめて所定の場所に置きます。</translation>
    </message>
    <message>
        <source>Fetching the native solver</source>
        <translation>ネイティブソルバーを取得しています</translation>
    </message>
    <message>
        <source>Fetching {0} ({1} MB) into {2}; only the file with SHA-256 {3} is kept.</source>
        <translation>{0}（{1} MB）を {2} に取得します。残すのは SHA-256 が {3} のファイルだけです。</translation>
    </message>
    <message>
        <source>Few panels or true to shape</source>
        <translation>少ないパネルか、形に忠実か</translation>
    </message>
    <message>
        <source>Few panels or true to shape?</source>
        <translation>少ないパネルか、形に忠実か？</translation>
    </message>
    <message>
        <source>Fields: {}, on {} of film</source>
        <translation>欄：{}、フィルム {}</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Files written to {}</source>
        <translation>ファイルを {} に書き出しました</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗りつぶし</translation>
    </message>
    <message>
        <source>Fill a closed line, or give an area another colour</source>
        <translation>閉じた線の中を塗る、または面の色を変える</translation>
    </message>
    <message>
        <source>Fill at the nozzle, to at most {column} of water.</source>
        <translation>ノズルから、水柱 {column} まででふくらませます。</translation>
    </message>
    <message>
        <source>Fill through a straw in the neck, to at most {column} of water.</source>
        <translation>首に差したストローから、水柱 {column} まででふくらませます。</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the seal across the neck, to at most {column} of water. Pull it out: the strips close by themselves.</source>
        <translation>先を斜めに切った 6 mm の管を、首を横切る溶着線の 25 mm 奥まで差し込み、水柱 {column} まででふくらませます。管を抜くと、帯がひとりでに閉じます。</translation>
    </message>
    <message>
        <source>Fill through a tube of 6 mm, its end cut aslant, pushed 25 mm past the weld across the neck. Pull it out: the pressure presses the strips together.</source>
        <translation>先を斜めに切った 6 mm の管を、首を横切る溶着線の 25 mm 奥まで差し込んでふくらませます。管を抜くと、内圧が帯を押し合わせて閉じます。</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and seam then keep a margin of {margin}.</source>
        <translation>{pressure} までふくらませ、{safe} を超えないようにします。フィルムと継ぎ目に {margin} 倍の余裕が残ります。</translation>
    </message>
    <message>
        <source>Fill to {pressure}, never above {safe}: film and weld then keep a margin of {margin}.</source>
        <translation>{pressure} までふくらませ、{safe} を超えないようにします。フィルムと溶着線に {margin} 倍の余裕が残ります。</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and seam bear with a margin of {margin}. Mind your eyes.</source>
        <translation>ふくらませるのは {safe} までにします。{pressure} は、フィルムと継ぎ目が {margin} 倍の余裕で耐えられる圧力を超えています。目を守ってください。</translation>
    </message>
    <message>
        <source>Fill to {safe} at most: {pressure} is more than film and weld bear with a margin of {margin}. Mind your eyes.</source>
        <translation>ふくらませるのは {safe} までにします。{pressure} は、フィルムと溶着線が {margin} 倍の余裕で耐えられる圧力を超えています。目を守ってください。</translation>
    </message>
    <message>
        <source>Fill with air a little and brush soapy water along the weld: bubbles show leaks. Weld once more there.</source>
        <translation>空気を少し入れ、溶着線に石けん水を塗ります。泡が出るところは漏れているので、もう一度溶着します。</translation>
    </message>
    <message>
        <source>Filled shape</source>
        <translation>塗った形</translation>
    </message>
    <message>
        <source>Filleted housing</source>
        <translation>フィレット付きの筐体</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>フィルム</translation>
    </message>
    <message>
        <source>Film Balloon {0} in FreeCAD {1}</source>
        <translation>Film Balloon {0}（FreeCAD {1}）</translation>
    </message>
    <message>
        <source>Film needed</source>
        <translation>必要なフィルム</translation>
    </message>
    <message>
        <source>Film needed: {0}</source>
        <translation>必要なフィルム：{0}</translation>
    </message>
    <message>
        <source>Film of your own</source>
        <translation>自分のフィルム</translation>
    </message>
    <message>
        <source>Film that it takes</source>
        <translation>必要なフィルム</translation>
    </message>
    <message>
        <source>Film width</source>
        <translation>フィルムの幅</translation>
    </message>
    <message>
        <source>Film {0} large is too much: write 500mm.</source>
        <translation>{0} のフィルムは大きすぎます。500mm のように書いてください。</translation>
    </message>
    <message>
        <source>Film: {0}</source>
        <translation>フィルム：{0}</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>フィルム</translation>
    </message>
    <message>
        <source>Find how much the film stretched, and how far the weld draws the seam inward</source>
        <translation>フィルムがどれだけ伸びたか、溶着で継ぎ目がどれだけ内側へ寄るかを求めます</translation>
    </message>
    <message>
        <source>Find its place</source>
        <translation>位置を自動で決める</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>気づいた点</translation>
    </message>
    <message>
        <source>Fit the film, too</source>
        <translation>フィルムも合わせる</translation>
    </message>
    <message>
        <source>Fit to drawing</source>
        <translation>図に合わせる</translation>
    </message>
    <message>
        <source>Fitting the pattern</source>
        <translation>型紙を合わせています</translation>
    </message>
    <message>
        <source>Flat pieces</source>
        <translation>平らな部品</translation>
    </message>
    <message>
        <source>Flattening needs scipy: install it with pip install scipy.</source>
        <translation>平らに広げるには scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Flower</source>
        <translation>花</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>Folder for the artwork</source>
        <translation>絵柄を入れるフォルダー</translation>
    </message>
    <message>
        <source>Follow every change at once</source>
        <translation>変更にすぐ追従する</translation>
    </message>
    <message>
        <source>Follows the body</source>
        <translation>立体に沿う</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>フォント</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. It looks for four marks, which lie on the layer Regmarks, are not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there, and four marks. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>inkscape-silhouette の「Send to Silhouette」用です。四つの印を探します。印はレイヤー Regmarks にあり、切りません。印は A4 の縁から 10 mm、間隔は 190 mm と 277 mm です。その値と、印が四つであることを Send to Silhouette に入れてください。印の外は切りません。ほかの用紙では、コピーした機械の page_mm を変えてください。</translation>
    </message>
    <message>
        <source>For Send to Silhouette of inkscape-silhouette. The marks of a print lie on the layer Regmarks, which is not cut, 10 mm from the edges of A4 and 190 and 277 mm apart: give that there. Nothing is cut outside them. For other paper change page_mm in a copy.</source>
        <translation>inkscape-silhouette の「Send to Silhouette」用です。印刷の印はレイヤー Regmarks にあり、切りません。印は A4 の縁から 10 mm、間隔は 190 mm と 277 mm です。その値を Send to Silhouette に入れてください。印の外は切りません。ほかの用紙では、コピーした機械の page_mm を変えてください。</translation>
    </message>
    <message>
        <source>For {0} of {1} pieces there is no room on the remnant: give film for the rest too.</source>
        <translation>残材には {1} 個のうち {0} 個の部品を置く場所がありません。残りのためのフィルムも指定してください。</translation>
    </message>
    <message>
        <source>For {0} the drawing would be {1} large: choose a volume that makes it {2} to {3}.</source>
        <translation>{0} にすると図の大きさは {1} になります。{2}～{3} になる体積を選んでください。</translation>
    </message>
    <message>
        <source>Forced</source>
        <translation>強制</translation>
    </message>
    <message>
        <source>Forget earlier photographs</source>
        <translation>前の写真を忘れる</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Frames are even in movement, not in time. Only the film has mass, the gas has none.</source>
        <translation>コマは時間ではなく動きに対して等間隔です。質量はフィルムだけにあり、気体にはありません。</translation>
    </message>
    <message>
        <source>FreeCAD does not start beside this one ({0}): install it for the Python that runs there.</source>
        <translation>別の FreeCAD が起動しません（{0}）。そこで動く Python から使えるように FreeCAD を入れてください。</translation>
    </message>
    <message>
        <source>FreeCAD failed while {0} ({1}). {2}</source>
        <translation>{0}中に FreeCAD が失敗しました（{1}）。{2}</translation>
    </message>
    <message>
        <source>FreeCAD has no material card "{0}": choose one of its material editor.</source>
        <translation>FreeCAD に材料カード「{0}」はありません。材料エディターのカードから選んでください。</translation>
    </message>
    <message>
        <source>FreeCAD needs a home folder and a temporary folder that it can write to, and enough memory.</source>
        <translation>書き込めるホームフォルダーと一時フォルダー、それにメモリーが必要です。</translation>
    </message>
    <message>
        <source>FreeCAD stopped while {0} ({1}). {2}</source>
        <translation>{0}中に FreeCAD が停止しました（{1}）。{2}</translation>
    </message>
    <message>
        <source>From</source>
        <translation>始め</translation>
    </message>
    <message>
        <source>From the flat film to the balloon at rest</source>
        <translation>平らなフィルムから、ふくらんで静止するまで</translation>
    </message>
    <message>
        <source>From this value, with its unit</source>
        <translation>この値から（単位付き）</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>表</translation>
    </message>
    <message>
        <source>Front and back as PNG and PDF, and as DXF and SVG with the same marks for the cutter</source>
        <translation>表と裏を PNG と PDF で、さらに同じ印の付いたカッター用の DXF と SVG で</translation>
    </message>
    <message>
        <source>Front, back and a band between them: change its width</source>
        <translation>表と裏、その間の帯：幅を変えてみてください</translation>
    </message>
    <message>
        <source>G-code, and no other format, has a tool: give both or none.</source>
        <translation>工具があるのは G コードだけで、ほかの形式にはありません。両方とも指定するか、両方とも外してください。</translation>
    </message>
    <message>
        <source>GRBL knows X, Y and Z only: leave turning_axis out, or take LinuxCNC or Marlin where an axis turns the tool.</source>
        <translation>GRBL には X、Y、Z しかありません。turning_axis を外すか、軸で工具を回すなら LinuxCNC か Marlin を使ってください。</translation>
    </message>
    <message>
        <source>GRBL machine (G-code)</source>
        <translation>GRBL の機械（G コード）</translation>
    </message>
    <message>
        <source>Gaps of up to {0} between lines were closed.</source>
        <translation>線の間の {0} までのすき間を閉じました。</translation>
    </message>
    <message>
        <source>Gas</source>
        <translation>気体</translation>
    </message>
    <message>
        <source>Gas that it takes, at the pressure outside</source>
        <translation>必要な気体（外の圧力で）</translation>
    </message>
    <message>
        <source>Give --artwork for the front too.</source>
        <translation>表の --artwork も指定してください。</translation>
    </message>
    <message>
        <source>Give --png or --report html with --ground: it is the ground of these.</source>
        <translation>--ground には --png か --report html を付けてください。それらの背景です。</translation>
    </message>
    <message>
        <source>Give a number of panels, into which the body is divided.</source>
        <translation>立体を分けるパネルの数を指定してください。</translation>
    </message>
    <message>
        <source>Give a study either "{0}" or "{1}".</source>
        <translation>スタディには「{0}」か「{1}」のどちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>Give either --material, or all of --young, --poisson and --thickness.</source>
        <translation>--material か、--young、--poisson、--thickness の三つすべてを指定してください。</translation>
    </message>
    <message>
        <source>Give either --scheduler or --dask.</source>
        <translation>--scheduler か --dask のどちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>Give either a volume or a lift as the goal.</source>
        <translation>目標には体積か浮力のどちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>Give one or two settings several values, such as 200, 300, 400, and each of the others one.</source>
        <translation>一つか二つの設定に 200, 300, 400 のように複数の値を、ほかの設定には値を一つずつ入れてください。</translation>
    </message>
    <message>
        <source>Give the document the values of the chosen row</source>
        <translation>選んだ行の値をドキュメントに入れます</translation>
    </message>
    <message>
        <source>Give {0} either "{1}" or "{2}", {3}.</source>
        <translation>{0} には「{1}」か「{2}」のどちらか一方を指定してください（{3}）。</translation>
    </message>
    <message>
        <source>Given</source>
        <translation>与えるもの</translation>
    </message>
    <message>
        <source>Glowforge</source>
        <translation>Glowforge</translation>
    </message>
    <message>
        <source>Glue</source>
        <translation>接着剤</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line. Let it dry under a weight.</source>
        <translation>破線に沿って幅 {seal} で接着します。重しをのせて乾かします。</translation>
    </message>
    <message>
        <source>Glue a strip of {seal} along the dashed line; leave the mouth of the neck open. Let it dry under a weight.</source>
        <translation>破線に沿って幅 {seal} で接着します。首の口は開けておきます。重しをのせて乾かします。</translation>
    </message>
    <message>
        <source>Glue the lines inside the balloon.</source>
        <translation>風船の内側の線を接着します。</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Does not hold gas for long and creases sharply.</source>
        <translation>継ぎ目は接着します。流れ方向の方が直角方向より硬く、E は幾何平均です。気体は長く保てず、折り目が鋭くつきます。</translation>
    </message>
    <message>
        <source>Glue the seams. Stiffer along the web than across it; E is the geometric mean. Porous: for a moment's inflation or with a lining.</source>
        <translation>継ぎ目は接着します。流れ方向の方が直角方向より硬く、E は幾何平均です。空気が抜けるので、短時間だけ使うか内張りをします。</translation>
    </message>
    <message>
        <source>Glued seam</source>
        <translation>接着の継ぎ目</translation>
    </message>
    <message>
        <source>Gores</source>
        <translation>ゴア</translation>
    </message>
    <message>
        <source>Grain</source>
        <translation>流れ方向</translation>
    </message>
    <message>
        <source>Grain lies</source>
        <translation>流れ方向の置き方</translation>
    </message>
    <message>
        <source>Graphtec with ARMS (vinyl cutter)</source>
        <translation>ARMS 付き Graphtec（カッティングマシン）</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>HPGL is written as polylines: give "arcs": false.</source>
        <translation>HPGL はポリラインで書かれます。"arcs": false にしてください。</translation>
    </message>
    <message>
        <source>HPGL plotter or vinyl cutter</source>
        <translation>HPGL プロッター、カッティングマシン</translation>
    </message>
    <message>
        <source>Half the outline and its axis; a copy of it travels in the document</source>
        <translation>輪郭の半分と軸。写しが文書に入ります</translation>
    </message>
    <message>
        <source>Heart</source>
        <translation>ハート</translation>
    </message>
    <message>
        <source>Heart from a spreadsheet</source>
        <translation>表で動くハート</translation>
    </message>
    <message>
        <source>Heat</source>
        <translation>熱</translation>
    </message>
    <message>
        <source>Heat sealer on a plotter</source>
        <translation>プロッター式ヒートシーラー</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height between two lines; empty: 5 mm</source>
        <translation>線と線の間で上げる高さ。空なら 5 mm</translation>
    </message>
    <message>
        <source>Helium</source>
        <translation>ヘリウム</translation>
    </message>
    <message>
        <source>High frequency</source>
        <translation>高周波</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}'</source>
        <translation>パネル「{1}」の穴 {0}</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' lies outside its film. Move it, or take it out.</source>
        <translation>パネル「{1}」の穴 {0} がフィルムの外にあります。動かすか、取り除いてください。</translation>
    </message>
    <message>
        <source>Hole {0} of panel '{1}' runs counter-clockwise. Turn the order of its points round.</source>
        <translation>パネル「{1}」の穴 {0} が反時計回りです。点の順を逆にしてください。</translation>
    </message>
    <message>
        <source>Holes from</source>
        <translation>穴の下限</translation>
    </message>
    <message>
        <source>Holes of the mesh that were closed: {0}.</source>
        <translation>閉じたメッシュの穴：{0}。</translation>
    </message>
    <message>
        <source>Home, then set X0 Y0 at the lower left corner of the film and Z0 where the tip touches the layer over it (G92); nothing homes. Lay baking paper or PTFE between tip and film, tape the film flat.</source>
        <translation>原点復帰をしてから、フィルムの左下の角を X0 Y0、こて先がフィルムの上の敷き物に触れる高さを Z0 にしてください（G92）。ファイルは原点復帰をしません。こて先とフィルムの間にクッキングシートか PTFE を敷き、フィルムを平らにしてテープで留めてください。</translation>
    </message>
    <message>
        <source>Hot tip</source>
        <translation>熱したこて先</translation>
    </message>
    <message>
        <source>Hot wheel</source>
        <translation>熱したホイール</translation>
    </message>
    <message>
        <source>Hours of welding, where they are known</source>
        <translation>溶着の時間（分かる場合）</translation>
    </message>
    <message>
        <source>How a balloon follows its pattern can be worked out for an elastic weld alone: choose that one.</source>
        <translation>型紙の変化に風船がどう従うかを計算できるのは、弾性の溶着線だけです。それを選んでください。</translation>
    </message>
    <message>
        <source>How far a closed cut runs past its start; empty: six times the knife's offset</source>
        <translation>閉じた切り線が始点を越えて進む長さ。空なら刃のオフセットの 6 倍</translation>
    </message>
    <message>
        <source>How far a closed weld runs past its start, so that the joint is tight</source>
        <translation>閉じた溶着線が始点を越えて進む長さ（継ぎ目の漏れを防ぐ）</translation>
    </message>
    <message>
        <source>How far a swivel knife or wheel lies behind its axis; 0 where the machine makes up for it</source>
        <translation>自在に回る刃やホイールが軸から遅れる距離。機械が補正するなら 0</translation>
    </message>
    <message>
        <source>How far along it</source>
        <translation>それに沿った位置</translation>
    </message>
    <message>
        <source>How far along its seam the opening is must be from 0 to 1.</source>
        <translation>継ぎ目に沿った開口の位置は 0～1 でなければなりません。</translation>
    </message>
    <message>
        <source>How far below the place where it touches the film it works: it presses so hard, or cuts so deep; of a laser its focus. Empty: not known yet</source>
        <translation>フィルムに触れる高さからどれだけ下で動かすか。押す強さや切る深さ、レーザーでは焦点になります。空ならまだ不明</translation>
    </message>
    <message>
        <source>How far the balloon may be from the body on average, of the body's diagonal</source>
        <translation>風船が立体から平均でどれだけ離れてよいか（立体の対角線に対する割合）</translation>
    </message>
    <message>
        <source>How far the outline moves if the weld creases could not be simulated. {0}</source>
        <translation>溶着線にしわが寄った場合に輪郭がどれだけ動くかを計算できませんでした。{0}</translation>
    </message>
    <message>
        <source>How far weld and film reach beyond the seam in the photograph; empty: as in the pattern, 0: folded back</source>
        <translation>写真で溶着線とフィルムが継ぎ目の外に出ている幅。空なら型紙のとおり、0 なら折り返してある</translation>
    </message>
    <message>
        <source>How fast it goes along a line; empty: not known yet</source>
        <translation>線に沿って進む速さ。空ならまだ不明</translation>
    </message>
    <message>
        <source>How long a way from waste film to a weld may be; 0 for none</source>
        <translation>捨てるフィルムから溶着線までの助走の最大の長さ。0 ならなし</translation>
    </message>
    <message>
        <source>How long it waits before it moves along a line: film warms, a beam burns in, a spindle starts</source>
        <translation>線に沿って動き出す前に待つ時間：フィルムが温まり、ビームが焼き込み、スピンドルが回り出します</translation>
    </message>
    <message>
        <source>How wide shall it be?</source>
        <translation>幅はどのくらいにしますか？</translation>
    </message>
    <message>
        <source>Hydrogen</source>
        <translation>水素</translation>
    </message>
    <message>
        <source>If the weld creases</source>
        <translation>溶着線にしわが寄る場合</translation>
    </message>
    <message>
        <source>If the weld creases, the outline may lie up to {0} away near {1}.</source>
        <translation>溶着線にしわが寄ると、{1} 付近で輪郭が最大 {0} ずれることがあります。</translation>
    </message>
    <message>
        <source>If the weld creases: {0} on average, at most {1}</source>
        <translation>溶着線にしわが寄る場合：平均 {0}、最大 {1}</translation>
    </message>
    <message>
        <source>In no seam yet: {}</source>
        <translation>まだ継ぎ目のない辺：{}</translation>
    </message>
    <message>
        <source>In {0} of {1} samples the pressure is above the safe one: fill it less.</source>
        <translation>{1} サンプルのうち {0} で、圧力が安全な圧力を超えています。充填を減らしてください。</translation>
    </message>
    <message>
        <source>Inflate as drawn</source>
        <translation>描いたままふくらませる</translation>
    </message>
    <message>
        <source>Inflate now</source>
        <translation>今すぐふくらませる</translation>
    </message>
    <message>
        <source>Inflate with these values and show the balloon</source>
        <translation>この値でふくらませて風船を表示する</translation>
    </message>
    <message>
        <source>Inflated</source>
        <translation>ふくらんだ形</translation>
    </message>
    <message>
        <source>Inflating</source>
        <translation>ふくらませています</translation>
    </message>
    <message>
        <source>Inflating in time</source>
        <translation>時間を追ってふくらませています</translation>
    </message>
    <message>
        <source>Inflating {0}</source>
        <translation>{0} をふくらませています</translation>
    </message>
    <message>
        <source>Inflation</source>
        <translation>膨張</translation>
    </message>
    <message>
        <source>Ink, or a slip of baking paper</source>
        <translation>インク、またはクッキングシートの小片</translation>
    </message>
    <message>
        <source>Inkscape</source>
        <translation>Inkscape</translation>
    </message>
    <message>
        <source>Intake</source>
        <translation>注入口</translation>
    </message>
    <message>
        <source>Intake in a side part</source>
        <translation>脇の部分にある注入口</translation>
    </message>
    <message>
        <source>Intake on a thin part</source>
        <translation>薄い部分にある注入口</translation>
    </message>
    <message>
        <source>It came with the workbench: copy it to set it up as your own.</source>
        <translation>ワークベンチに付属する機械です。自分用に設定するにはコピーしてください。</translation>
    </message>
    <message>
        <source>It holds {} of the air that a round balloon of as much film would.</source>
        <translation>入る空気は、同じ量のフィルムで作る丸い風船の {} です。</translation>
    </message>
    <message>
        <source>It is filled to {0}, its safe pressure is {1}: fill it less.</source>
        <translation>圧力は {0} ですが、安全な圧力は {1} です。空気を減らしてください。</translation>
    </message>
    <message>
        <source>It is not inflated yet: choose Inflate now in its context menu, or switch Live on.</source>
        <translation>まだふくらんでいません。コンテキストメニューで「今すぐふくらませる」を選ぶか、ライブをオンにしてください。</translation>
    </message>
    <message>
        <source>It is not repeated on the other side. {0}</source>
        <translation>反対側では繰り返しません。{0}</translation>
    </message>
    <message>
        <source>It is wider now. Ctrl+Z takes that back.</source>
        <translation>広くしました。Ctrl+Z で元に戻せます。</translation>
    </message>
    <message>
        <source>It lies</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>It meets what it was designed for</source>
        <translation>設計の目的を満たしている</translation>
    </message>
    <message>
        <source>It needs more places: give them all.</source>
        <translation>位置が足りません。すべて指定してください。</translation>
    </message>
    <message>
        <source>It takes {0} h at {1} m/min and {2} min for each seam.</source>
        <translation>{1} m/min、シーム 1 本あたり {2} 分で {0} 時間かかります。</translation>
    </message>
    <message>
        <source>It took longer than {0} s: take a coarser mesh, or raise --timeout.</source>
        <translation>{0} 秒を超えました。メッシュを粗くするか、--timeout を大きくしてください。</translation>
    </message>
    <message>
        <source>Its pattern is gone: delete it.</source>
        <translation>元の型紙がありません。これを削除してください。</translation>
    </message>
    <message>
        <source>Its process ended with {0} ({1}).</source>
        <translation>プロセスが {0} で終わりました（{1}）。</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.</source>
        <translation>プロセスが {0} で終了しました。</translation>
    </message>
    <message>
        <source>Its process was ended by {0}. It may have lacked memory: take a coarser mesh.</source>
        <translation>プロセスが {0} で終了しました。メモリーが足りなかった可能性があります。メッシュを粗くしてください。</translation>
    </message>
    <message>
        <source>Its process was ended by {0}.{1}</source>
        <translation>プロセスが {0} で終了しました。{1}</translation>
    </message>
    <message>
        <source>Its workers were killed again and again: take a coarser mesh, or start it again.</source>
        <translation>ワーカーが何度も強制終了されました。メッシュを粗くするか、もう一度始めてください。</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>Jobs of a study is 0 or more: 0 takes one for each processor.</source>
        <translation>スタディの Jobs は 0 以上です。0 ならプロセッサーごとに 1 つになります。</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide, all the way round.</source>
        <translation>破線に沿って幅 {seal} で、ぐるりと 1 周接合します。</translation>
    </message>
    <message>
        <source>Join the panels along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>破線に沿って幅 {seal} で接合します。首の口は開けておきます。</translation>
    </message>
    <message>
        <source>Join the panels along the lines inside the balloon.</source>
        <translation>風船の内側の線に沿って 2 枚を接合します。</translation>
    </message>
    <message>
        <source>Joined</source>
        <translation>つなげる</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>残す</translation>
    </message>
    <message>
        <source>Keep the best</source>
        <translation>最も良いものを残す</translation>
    </message>
    <message>
        <source>Keep the film</source>
        <translation>フィルムを残す</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>縦横比を保つ</translation>
    </message>
    <message>
        <source>Keep what is left</source>
        <translation>残りを保存</translation>
    </message>
    <message>
        <source>Keep what is left...</source>
        <translation>残りを保存...</translation>
    </message>
    <message>
        <source>Kept, and offered by Export pattern: {}</source>
        <translation>残しました。「型紙を書き出す」で選べます：{}</translation>
    </message>
    <message>
        <source>Kerf</source>
        <translation>切り幅</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Knife</source>
        <translation>刃</translation>
    </message>
    <message>
        <source>Knife offset</source>
        <translation>刃のオフセット</translation>
    </message>
    <message>
        <source>Kraft paper, 80 g/m²</source>
        <translation>クラフト紙、80 g/m²</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Labels need matplotlib: install it with pip install matplotlib, or leave the label empty.</source>
        <translation>文字には matplotlib が必要です。pip install matplotlib で入れるか、文字を空にしてください。</translation>
    </message>
    <message>
        <source>Laid flat</source>
        <translation>平らに広げたとき</translation>
    </message>
    <message>
        <source>Laid one piece after another: the package spyrrow (pip install spyrrow) often finds a closer layout.</source>
        <translation>部品を一つずつ並べました。パッケージ spyrrow（pip install spyrrow）なら、もっと詰まった並べ方が見つかることがよくあります。</translation>
    </message>
    <message>
        <source>Largest strain</source>
        <translation>最大ひずみ</translation>
    </message>
    <message>
        <source>Largest tension of the film</source>
        <translation>フィルムの最大張力</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>レーザー</translation>
    </message>
    <message>
        <source>Lay a picture under the paper for tracing; press again to take it away</source>
        <translation>なぞるための画像を紙の下に敷く（もう一度押すと外す）</translation>
    </message>
    <message>
        <source>Lay both valve strips on each other, their lines together. On the field marked on VALVE, INK put heat-resistant ink, or a slip of baking paper between the strips. Weld them along both long lines.</source>
        <translation>弁の帯 2 本を、線を合わせて重ねます。VALVE, INK の帯の印の枠に、耐熱インクを塗るか、帯の間にクッキングシートの小片をはさみます。2 本の長い線に沿って溶着します。</translation>
    </message>
    <message>
        <source>Lay edges of the same number on each other, inner sides together: arrows the same way, the lines across the weld and the notches on each other. Tape outside the cut.</source>
        <translation>同じ番号の辺を内側どうし重ねます。矢印の向きをそろえ、溶着線を横切る線とノッチを合わせます。切り線の外をテープで留めます。</translation>
    </message>
    <message>
        <source>Lay out</source>
        <translation>並べる</translation>
    </message>
    <message>
        <source>Lay out anew</source>
        <translation>並べ直す</translation>
    </message>
    <message>
        <source>Lay out on film</source>
        <translation>フィルムに並べる</translation>
    </message>
    <message>
        <source>Lay the grain of all panels along the line with two arrowheads.</source>
        <translation>すべてのパネルのフィルムの目を、両端に矢印のある線に合わせます。</translation>
    </message>
    <message>
        <source>Lay the grain of both panels the same way.</source>
        <translation>2 枚の流れ方向をそろえます。</translation>
    </message>
    <message>
        <source>Lay the panels on each other, sealing sides inward. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>シール面を内側にして 2 枚を重ねます。合印か縁で位置を合わせ、切り線の外側をテープで留めます。</translation>
    </message>
    <message>
        <source>Lay the panels on each other. Line them up by the notches or edges; tape outside the cut.</source>
        <translation>2 枚を重ねます。合印か縁で位置を合わせ、切り線の外側をテープで留めます。</translation>
    </message>
    <message>
        <source>Lay the strips into the neck of one panel, end at the mouth, line on line. Tack them to this panel only, with two spots of weld on the line, beside the channel.</source>
        <translation>帯を片方のフィルムの首に置き、端を口に、線を線に合わせます。このフィルムだけに、通り道の脇の線上 2 か所を点で溶着して仮留めします。</translation>
    </message>
    <message>
        <source>Layers, millimetres and arcs, to go on drawing.</source>
        <translation>続きを描くための、レイヤー、ミリメートル、円弧。</translation>
    </message>
    <message>
        <source>Laying out {0}</source>
        <translation>{0} を並べています</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>助走</translation>
    </message>
    <message>
        <source>Leak test: fill with air through a tube in the neck, closed round it by hand or with tape, to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>漏れの検査：首に差した管から空気を入れ、管のまわりを手かテープでふさぎます。ホースの水柱で {column} までにします。15 分待ち、継ぎ目に石けん水を塗ります。泡が大きくなる所にペンで印を付け、空気を抜き、乾かし、そこをもう一度溶着して、検査をやり直します。</translation>
    </message>
    <message>
        <source>Leak test: fill with air to at most {column} of water in a hose. Wait 15 min, brush soapy water along the seams. Mark with a pen where bubbles grow, let the air out, dry it, seal there once more, test again.</source>
        <translation>漏れの検査：ホースの水柱で {column} まで空気を入れます。15 分待ち、継ぎ目に石けん水を塗ります。泡が大きくなる所にペンで印を付け、空気を抜き、乾かし、そこをもう一度溶着して、検査をやり直します。</translation>
    </message>
    <message>
        <source>Leave tabs so wide in the cuts, such as 0.4 mm, on straights, two or more on each and one in 100 mm, so that pieces stay in the film. It is kept for this machine</source>
        <translation>切り線のまっすぐな部分に、0.4 mm のような幅のタブを、それぞれ 2 つ以上、100 mm ごとに 1 つ残し、部品がフィルムから外れないようにします。この機械の値として保存されます</translation>
    </message>
    <message>
        <source>Left out: {0}</source>
        <translation>省きました：{0}</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Length of a gore</source>
        <translation>ゴア 1 枚の長さ</translation>
    </message>
    <message>
        <source>Length of the seams</source>
        <translation>継ぎ目の長さ</translation>
    </message>
    <message>
        <source>Length of the usual roll that it takes</source>
        <translation>必要な通常のロールの長さ</translation>
    </message>
    <message>
        <source>Let all pieces lie as the pattern lays them</source>
        <translation>すべての部品を型紙どおりの位置に戻します</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>文字の風船</translation>
    </message>
    <message>
        <source>Letter height</source>
        <translation>文字の高さ</translation>
    </message>
    <message>
        <source>Letter with a side band</source>
        <translation>側面の帯のある文字</translation>
    </message>
    <message>
        <source>Letters on a ground that makes one balloon of them</source>
        <translation>文字の下に土台を敷き、ひとつの風船にします</translation>
    </message>
    <message>
        <source>Letters, digits, spaces and - only</source>
        <translation>英数字、空白、- だけ</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>浮力</translation>
    </message>
    <message>
        <source>Lift in g</source>
        <translation>浮力（g）</translation>
    </message>
    <message>
        <source>Lift needs vertices of the balloon that hold it. Give those of its lower end.</source>
        <translation>浮力には、それを支える風船の節点が必要です。下端の節点を指定してください。</translation>
    </message>
    <message>
        <source>LightBurn (laser)</source>
        <translation>LightBurn（レーザー）</translation>
    </message>
    <message>
        <source>LightBurn has too few layers for panels in holes of panels: lay out fewer.</source>
        <translation>部品の穴の中にさらに部品があり、LightBurn のレイヤーが足りません。並べる数を減らしてください。</translation>
    </message>
    <message>
        <source>LightBurn project (laser)</source>
        <translation>LightBurn プロジェクト（レーザー）</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Lines it inside</source>
        <translation>立体の内側に張る</translation>
    </message>
    <message>
        <source>Lines that close around nothing beside the shapes were left out.</source>
        <translation>形のそばにある、何も囲まない線は無視しました。</translation>
    </message>
    <message>
        <source>Lines up to</source>
        <translation>線の上限</translation>
    </message>
    <message>
        <source>LinuxCNC machine (G-code)</source>
        <translation>LinuxCNC の機械（G コード）</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>ライブ</translation>
    </message>
    <message>
        <source>Longest piece of the band</source>
        <translation>帯 1 本の最大長さ</translation>
    </message>
    <message>
        <source>Look for the closest layout; Esc takes the best one so far</source>
        <translation>最も詰まった並べ方を探す（Esc でそれまでの最良を採用）</translation>
    </message>
    <message>
        <source>Loose ends of lines were joined to the drawing.</source>
        <translation>線の端を図につなぎました。</translation>
    </message>
    <message>
        <source>Loose film: {0}, wrinkled: {1}; wrinkles hide {2} of it</source>
        <translation>たるんでいるフィルム：{0}、しわになっているフィルム：{1}、しわに隠れる分：{2}</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>低い所</translation>
    </message>
    <message>
        <source>Lower end</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>機械</translation>
    </message>
    <message>
        <source>Made with brush and pen: double-click the Outline to paint on</source>
        <translation>ブラシとペンで描いたもの。輪郭をダブルクリックすると続きを描けます</translation>
    </message>
    <message>
        <source>Make a card</source>
        <translation>カードを作る</translation>
    </message>
    <message>
        <source>Make a machine of your own with the values of this one</source>
        <translation>この機械の値で自分の機械を作ります</translation>
    </message>
    <message>
        <source>Make a sketch of the cuts</source>
        <translation>切り線のスケッチを作る</translation>
    </message>
    <message>
        <source>Make a test card: nobody states a temperature for this film.</source>
        <translation>テストカードを作ってください。このフィルムの温度はどこにも示されていません。</translation>
    </message>
    <message>
        <source>Make it!</source>
        <translation>作る！</translation>
    </message>
    <message>
        <source>Make rows</source>
        <translation>行を作る</translation>
    </message>
    <message>
        <source>Make the balloon smaller and inflate it again, until its pattern fits the bed. Weld and allowance keep their widths; one undo takes it back</source>
        <translation>型紙が加工台に収まるまで、風船を小さくしてふくらませ直します。溶着と余白の幅は変わりません。「元に戻す」1 回で戻ります</translation>
    </message>
    <message>
        <source>Making tool paths</source>
        <translation>ツールパスを作っています</translation>
    </message>
    <message>
        <source>Mark a length</source>
        <translation>長さに印を付ける</translation>
    </message>
    <message>
        <source>Mark a length in the picture, and give its true length, such as 300 mm.</source>
        <translation>画像の中の長さに印を付け、300 mm のように実際の長さを入れてください。</translation>
    </message>
    <message>
        <source>Mark a length…</source>
        <translation>長さに印を付ける…</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>印</translation>
    </message>
    <message>
        <source>Marks for</source>
        <translation>印の種類</translation>
    </message>
    <message>
        <source>Marlin printer (G-code)</source>
        <translation>Marlin の 3D プリンター（G コード）</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>May be cut</source>
        <translation>切ってよい</translation>
    </message>
    <message>
        <source>Mean distance from the body</source>
        <translation>立体からの平均距離</translation>
    </message>
    <message>
        <source>Measure (M)</source>
        <translation>測る (M)</translation>
    </message>
    <message>
        <source>Measured on the inflated balloon.</source>
        <translation>ふくらんだ風船で測定しました。</translation>
    </message>
    <message>
        <source>Membrane tension</source>
        <translation>膜張力</translation>
    </message>
    <message>
        <source>Merge</source>
        <translation>結合</translation>
    </message>
    <message>
        <source>Mesh reuse needs scipy: install it with pip install scipy.</source>
        <translation>メッシュの再利用には scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Mesh size</source>
        <translation>メッシュの大きさ</translation>
    </message>
    <message>
        <source>Mesh size (0: automatic)</source>
        <translation>メッシュの大きさ（0：自動）</translation>
    </message>
    <message>
        <source>Meshing needs scipy: install it with pip install scipy.</source>
        <translation>メッシュ作成には scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Mimaki with register marks (vinyl cutter)</source>
        <translation>レジスターマーク対応の Mimaki（カッティングマシン）</translation>
    </message>
    <message>
        <source>Mind</source>
        <translation>注意</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>反転</translation>
    </message>
    <message>
        <source>Mirror piece</source>
        <translation>部品を反転</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>モード</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>モデル</translation>
    </message>
    <message>
        <source>More gores hardly help: change the profile.</source>
        <translation>ゴアを増やしてもほとんど変わりません。断面を変えてください。</translation>
    </message>
    <message>
        <source>More: text, stamps, layers, symmetry, any colour (Q)</source>
        <translation>もっと：文字、スタンプ、レイヤー、対称、好きな色（Q）</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Move piece</source>
        <translation>部品を移動</translation>
    </message>
    <message>
        <source>Move the pointer to bend the line, then click. Esc drops it.</source>
        <translation>ポインターを動かして線を曲げ、クリックします。Esc で取り消します。</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline in a tab, over the picture</source>
        <translation>タブの中で、画像の上の輪郭のノードを動かし、加え、消します</translation>
    </message>
    <message>
        <source>My machines</source>
        <translation>自分の機械</translation>
    </message>
    <message>
        <source>My {}</source>
        <translation>自分の {}</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the machine</source>
        <translation>機械の名前</translation>
    </message>
    <message>
        <source>Native</source>
        <translation>ネイティブ</translation>
    </message>
    <message>
        <source>Natural shape</source>
        <translation>自然形</translation>
    </message>
    <message>
        <source>Near {0} the film stays {1} from the body, which is too thin or too sharp there for panels. Cut such a part off, or divide the body along it.</source>
        <translation>{0} の近くでフィルムが立体から {1} 離れています。そこは細すぎるか、とがりすぎていてパネルでは作れません。その部分を切り取るか、それに沿って立体を分けてください。</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: film cannot follow it there. Round it off or widen it.</source>
        <translation>{0} 付近で、ふくらんだ輪郭が {2} にわたって図から最大 {1} 離れます。フィルムはそこに追従できません。丸めるか広げてください。</translation>
    </message>
    <message>
        <source>Near {0} the inflated outline stays up to {1} from the drawing, over a length of {2}: the balloon folds across a hole or a spot. Make that larger, or leave it out.</source>
        <translation>{0} 付近で、ふくらんだ輪郭が {2} にわたって図から最大 {1} 離れます。風船が穴か溶着した点を横切って折れています。その穴か点を大きくするか、なくしてください。</translation>
    </message>
    <message>
        <source>Neck that chokes the air path</source>
        <translation>空気の通りを妨げるくびれ</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>必要量</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>絶対に不可</translation>
    </message>
    <message>
        <source>Never cut PVC with a laser: it gives off hydrogen chloride, which is toxic and ruins the machine. Weld with high frequency or hot air. Stretches visibly: at 2 kPa the shape depends on the grade and on the pressure.</source>
        <translation>PVC は絶対にレーザーで切らないでください。有毒で機械を傷める塩化水素が出ます。高周波か熱風で溶着します。目に見えて伸び、2 kPa では形が材質と圧力で変わります。</translation>
    </message>
    <message>
        <source>Never cut this film with a laser.</source>
        <translation>このフィルムは絶対にレーザーで切らないでください。</translation>
    </message>
    <message>
        <source>New bag of panels</source>
        <translation>新しいパネルの袋</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>立体から新しい風船</translation>
    </message>
    <message>
        <source>New balloon from picture</source>
        <translation>画像から新しい風船</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>スケッチから新しい風船</translation>
    </message>
    <message>
        <source>New balloons</source>
        <translation>新しい風船</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>新しいゴアの立体</translation>
    </message>
    <message>
        <source>New, laid beside the others: {}.</source>
        <translation>新しい部品（ほかの隣に置きました）：{}。</translation>
    </message>
    <message>
        <source>Newmark</source>
        <translation>Newmark</translation>
    </message>
    <message>
        <source>No axis turns a {0}: leave {1} out.</source>
        <translation>この工具（{0}）を回す軸はありません。{1} を外してください。</translation>
    </message>
    <message>
        <source>No balloon came within {0} of the body's diagonal: tried were {1} panels. This is the nearest one, {2}. Ask for less, or divide the body yourself where the film stays far from it.</source>
        <translation>立体の対角線の {0} 以内に収まる風船がありませんでした。試したパネルの数は {1} です。最も近いのはこの風船で、{2} です。求める精度を下げるか、フィルムが離れている所で立体を自分で分けてください。</translation>
    </message>
    <message>
        <source>No balloon can be inflated anew without it; patterns can be changed and written.</source>
        <translation>これがないと風船を新たにふくらませられません。型紙の変更と書き出しはできます。</translation>
    </message>
    <message>
        <source>No balloon has {0} and {1}: these limits exclude each other.</source>
        <translation>「{0}」と「{1}」を同時に満たす風船はありません。この二つの制限は両立しません。</translation>
    </message>
    <message>
        <source>No file could be made.</source>
        <translation>ファイルを 1 つも作れませんでした。</translation>
    </message>
    <message>
        <source>No file for {0}: {1}</source>
        <translation>{0} 用のファイルは作れません：{1}</translation>
    </message>
    <message>
        <source>No file is like '{0}' in '{1}'. Check the pattern and the folder.</source>
        <translation>「{1}」に「{0}」に合うファイルがありません。検索パターンとフォルダーを確かめてください。</translation>
    </message>
    <message>
        <source>No limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>No longer in the pattern, with their places: {}.</source>
        <translation>型紙からなくなった部品とその位置：{}。</translation>
    </message>
    <message>
        <source>No number of panels up to {} comes so near. {} panels: about {} off</source>
        <translation>{} 枚までのパネルでは、そこまで近づきません。パネル {} 枚：ずれ約 {}</translation>
    </message>
    <message>
        <source>No panel has an edge "{0}": choose one of an outline or face of this bag.</source>
        <translation>「{0}」という辺のあるパネルはありません。この袋の輪郭か面の辺を選んでください。</translation>
    </message>
    <message>
        <source>No panel of the balloon is cut: make at least one of film.</source>
        <translation>切り出すパネルがありません。少なくとも 1 枚をフィルムにしてください。</translation>
    </message>
    <message>
        <source>No pattern can be drawn anew without it; documents keep theirs.</source>
        <translation>これがないと型紙を新たに描けません。文書にある型紙は残ります。</translation>
    </message>
    <message>
        <source>No pattern here has pieces of "{0}": choose another film.</source>
        <translation>ここの型紙には「{0}」の部品がありません。別のフィルムを選んでください。</translation>
    </message>
    <message>
        <source>No process can be started beside this one ({0}).</source>
        <translation>別のプロセスを起動できません（{0}）。</translation>
    </message>
    <message>
        <source>No row of {0} makes sense: {1}</source>
        <translation>{0} に使える行がありません：{1}</translation>
    </message>
    <message>
        <source>No seam can be drawn near {0}.</source>
        <translation>{0} 付近には継ぎ目を描けません。</translation>
    </message>
    <message>
        <source>No shape in the photograph is like the one that was expected: take it straight from the front, on a plain background without anything else in it.</source>
        <translation>写真の中に予想した形に似たものがありません。無地の背景で、ほかのものを入れずに、真正面から撮ってください。</translation>
    </message>
    <message>
        <source>No shape stands out in the picture. Use stronger colours or a plainer background.</source>
        <translation>画像の中に形が見つかりません。はっきりした色か、無地に近い背景にしてください。</translation>
    </message>
    <message>
        <source>No size of the balloon fits a bed of {0}: weld, allowance, intake and control bar keep their sizes. Choose another machine.</source>
        <translation>風船をどの大きさにしても {0} の加工台に収まりません。溶着、余白、注入口、確認用の棒の大きさは変わらないためです。別の機械を選んでください。</translation>
    </message>
    <message>
        <source>No solver works here.</source>
        <translation>使えるソルバーがありません。</translation>
    </message>
    <message>
        <source>No solver works here: {0}</source>
        <translation>使えるソルバーがありません：{0}</translation>
    </message>
    <message>
        <source>No solver works here: {0} Build it or install the package scipy.</source>
        <translation>使えるソルバーがありません：{0} ソルバーをビルドするか、パッケージ scipy を入れてください。</translation>
    </message>
    <message>
        <source>No speed and power are known for {0}, so none are written: set them in LightBurn, or give speed_mm_s and max_power_percent in a file of your machine.</source>
        <translation>{0} の速度と出力が分からないため、書き出しません。LightBurn で設定するか、自分の機械のファイルに speed_mm_s と max_power_percent を書いてください。</translation>
    </message>
    <message>
        <source>No triangle of the mesh has an area. Save the body as a mesh of triangles.</source>
        <translation>メッシュのどの三角形にも面積がありません。立体を三角形のメッシュとして保存してください。</translation>
    </message>
    <message>
        <source>No worker of Dask can be reached at '{0}' ({1}): start a scheduler and workers, and give its address.</source>
        <translation>「{0}」で Dask のワーカーに接続できません（{1}）。スケジューラーとワーカーを起動し、そのアドレスを指定してください。</translation>
    </message>
    <message>
        <source>No, use NumPy</source>
        <translation>いいえ、NumPy を使う</translation>
    </message>
    <message>
        <source>Nobody but you knows the {0} of your {1} for this film: fill in My machines in FreeCAD, or give {2}.</source>
        <translation>このフィルムに対する自分の {1} の{0}は、使う人にしか分かりません。FreeCAD の「自分の機械」に書くか、{2} を指定してください。</translation>
    </message>
    <message>
        <source>Nobody but you knows this: {}. Give one value, or several to try.</source>
        <translation>使う人にしか分からない値です：{}。値を一つ、または試す値をいくつか入れてください。</translation>
    </message>
    <message>
        <source>Nobody states a temperature for this film. Make a test card: weld strips with several temperatures and times, peel them, keep the best.</source>
        <translation>このフィルムの温度はどこにも示されていません。テストカードを作り、いろいろな温度と時間で帯を溶着し、はがして、最も良いものを残してください。</translation>
    </message>
    <message>
        <source>Nodes of the outline</source>
        <translation>輪郭のノード</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>None of {0} balloons could be made: the table says why.</source>
        <translation>{0} 個の風船はどれも作れませんでした。理由は表にあります。</translation>
    </message>
    <message>
        <source>None of {0} balloons is within the limits; the nearest: {1}, asked for {2}.</source>
        <translation>{0} 個の風船はどれも制限の内にありません。最も近いもの：{1}、要求：{2}。</translation>
    </message>
    <message>
        <source>Not all holes are seen in the photograph: those that are not count as wrong.</source>
        <translation>写真に写っていない穴があります。写っていない穴は違いとして数えます。</translation>
    </message>
    <message>
        <source>Not possible</source>
        <translation>不可</translation>
    </message>
    <message>
        <source>Notch with a stress peak</source>
        <translation>応力が集中する切れ込み</translation>
    </message>
    <message>
        <source>Notches</source>
        <translation>合印</translation>
    </message>
    <message>
        <source>Notches of {0} do not end before the weld: the allowance is {1}.</source>
        <translation>{0} の合印は溶着線に届きます。余白は {1} です。</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>Note: {0}</source>
        <translation>注意：{0}</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>注記</translation>
    </message>
    <message>
        <source>Nothing can be computed without it; documents open and keep their shapes.</source>
        <translation>これがないと何も計算できません。文書は開け、形は残ります。</translation>
    </message>
    <message>
        <source>Nothing here writes an MP4: choose a GIF, or install opencv-python-headless with pip.</source>
        <translation>ここでは MP4 を書き出せません。GIF を選ぶか、pip で opencv-python-headless を入れてください。</translation>
    </message>
    <message>
        <source>Nothing strays that is called "{0}": choose of {1}.</source>
        <translation>「{0}」というばらつきはありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>Nothing to improve.</source>
        <translation>直すところはありません。</translation>
    </message>
    <message>
        <source>Nothing varies in {0}: write into its first row what does, such as Width.</source>
        <translation>{0} では何も変わりません。1 行目に、変えるものを Width のように書いてください。</translation>
    </message>
    <message>
        <source>Nothing varies: give "{0}" a column.</source>
        <translation>変わるものがありません。「{0}」に列を指定してください。</translation>
    </message>
    <message>
        <source>Now pick the partner of {}.</source>
        <translation>{} の相手の辺を選んでください。</translation>
    </message>
    <message>
        <source>Nowhere on the seam is room for an intake of {0}: choose a narrower one, or a place for it.</source>
        <translation>幅 {0} の注入口を付ける場所が外周のどこにもありません。細い注入口にするか、位置を指定してください。</translation>
    </message>
    <message>
        <source>Nozzle with flange</source>
        <translation>フランジ付きノズル</translation>
    </message>
    <message>
        <source>NumPy computes the same, 20 to 30 times slower.</source>
        <translation>NumPy でも同じ計算ができますが、20～30 倍の時間がかかります。</translation>
    </message>
    <message>
        <source>NumPy took 20 to 30 times longer than the native solver, which fetch-solver fetches.</source>
        <translation>NumPy での計算には、ネイティブソルバーの 20～30 倍の時間がかかりました。ネイティブソルバーは fetch-solver で取得できます。</translation>
    </message>
    <message>
        <source>Number of panels</source>
        <translation>パネルの数</translation>
    </message>
    <message>
        <source>Number of values, both ends among them</source>
        <translation>値の数（両端を含む）</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>OK, then {}</source>
        <translation>OK のあと {}</translation>
    </message>
    <message>
        <source>Of a card one field is kept: give --keep B3, or another one, and --name.</source>
        <translation>カードからは一つの欄を残します: --keep B3 などと --name を指定してください。</translation>
    </message>
    <message>
        <source>Of a symmetric outline the other side is edited, too</source>
        <translation>対称な輪郭では、反対側も同じように編集します</translation>
    </message>
    <message>
        <source>Of the bodies of the mesh only the largest is made; all in all there are: {0}.</source>
        <translation>メッシュの立体のうち、最大のものだけを作ります。全部の数：{0}。</translation>
    </message>
    <message>
        <source>Of the film of {0} nothing is left that is large enough to be used again.</source>
        <translation>{0} のフィルムには、また使えるほど大きな残りがありません。</translation>
    </message>
    <message>
        <source>Of the tip or wheel, 40 to 400 °C. Above 260 °C a layer of PTFE gives off poisonous fumes</source>
        <translation>こて先やホイールの温度、40～400 °C。260 °C を超えると PTFE の敷き物が有毒な煙を出します</translation>
    </message>
    <message>
        <source>Of {0}: sheet {1}.</source>
        <translation>{0}：シート {1}。</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Off at most</source>
        <translation>最大のずれ</translation>
    </message>
    <message>
        <source>Off it at most</source>
        <translation>そこからの最大のずれ</translation>
    </message>
    <message>
        <source>Off on average</source>
        <translation>平均のずれ</translation>
    </message>
    <message>
        <source>Off the body</source>
        <translation>立体からのずれ</translation>
    </message>
    <message>
        <source>Off the drawing</source>
        <translation>図からのずれ</translation>
    </message>
    <message>
        <source>Off the drawing, profile or body on average</source>
        <translation>図、断面、立体からのずれ（平均）</translation>
    </message>
    <message>
        <source>Off the drawing: {0} on average, at most {1}</source>
        <translation>図からのずれ：平均 {0}、最大 {1}</translation>
    </message>
    <message>
        <source>Off the profile</source>
        <translation>断面からのずれ</translation>
    </message>
    <message>
        <source>Off the {0}: {1} on average, 95 % below {2}, at most {3}</source>
        <translation>{0}からのずれ：平均 {1}、95 % が {2} 以下、最大 {3}</translation>
    </message>
    <message>
        <source>Offer the native solver where it is missing</source>
        <translation>ネイティブソルバーがないときに取得するか尋ねる</translation>
    </message>
    <message>
        <source>On a symmetric body a change is repeated where its mirror image lies</source>
        <translation>対称な立体では、変更を鏡像の位置でも繰り返します</translation>
    </message>
    <message>
        <source>On the way of the valve the balloon narrows to {0} at {1}; its channel takes {2} with its welds there. Make the neck wider or put it elsewhere, else the weld closes the valve.</source>
        <translation>弁の通る所で風船が {1} で {0} に狭まります。そこで弁の通り道は溶着線を含めて {2} 必要です。首を広くするか別の所に付けないと、溶着で弁がふさがります。</translation>
    </message>
    <message>
        <source>Once the seam is closed, turn the tail in through itself with a straw, at the mark beside the balloon, and fill through it up to the second mark. Pull the straw out: the air in the balloon presses the tail flat.</source>
        <translation>継ぎ目を閉じたら、風船のそばの印で尾をストローで内側へ裏返し、2 番目の印までストローを入れて空気を入れます。ストローを抜くと、中の空気が尾を平らに押さえます。</translation>
    </message>
    <message>
        <source>One large page</source>
        <translation>大きな 1 ページ</translation>
    </message>
    <message>
        <source>One-way tail</source>
        <translation>逆止めの尾</translation>
    </message>
    <message>
        <source>Only a film with another stiffness across has a grain: give --young-across too.</source>
        <translation>流れ方向があるのは、直角方向の硬さが違うフィルムだけです。--young-across も指定してください。</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one with --flat.</source>
        <translation>写真と比べられるのは同じ 2 枚のパネルの風船だけです。ほかの風船は --flat でパネルを 1 枚ずつ比べてください。</translation>
    </message>
    <message>
        <source>Only balloons of two equal panels are compared with a photograph: compare the panels of others one by one, with the command compare and its --flat.</source>
        <translation>写真と比べられるのは同じ 2 枚のパネルの風船だけです。ほかの風船は、コマンド compare と --flat でパネルを 1 枚ずつ比べてください。</translation>
    </message>
    <message>
        <source>Only grades of this film with a sealing layer weld: try scraps before you cut.</source>
        <translation>このフィルムで溶着できるのはシール層のある品種だけです。切る前に端切れで試してください。</translation>
    </message>
    <message>
        <source>Only pieces that are no larger than this either way get tabs, such as 50 mm</source>
        <translation>縦横ともこの大きさ以下の部品だけにタブを付けます（50 mm など）</translation>
    </message>
    <message>
        <source>Only the middle of the weld. A closed weld runs past its start, so that the joint is tight.</source>
        <translation>溶着線の中心だけです。閉じた線は始点を少し越えて重なり、継ぎ目の漏れを防ぎます。</translation>
    </message>
    <message>
        <source>Only the shape is compared, at the size that fits best</source>
        <translation>形だけを、最もよく合う大きさで比べます</translation>
    </message>
    <message>
        <source>Only {0} of film stay between two cuts near {1}; {2} wants {3}. It may tear or melt there.</source>
        <translation>{1} 付近で 2 本の切り線の間が {0} しかありません。{2} には {3} 必要です。破れたり溶けたりするおそれがあります。</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開いたまま</translation>
    </message>
    <message>
        <source>Open edge: {}</source>
        <translation>開いた辺: {}</translation>
    </message>
    <message>
        <source>Open it, do not import it. Outline, holes and notches are on cut layers, without speed and power: take them from your material library. Welds (T1) and all that is drawn (T2) are on tool layers, which LightBurn never burns.</source>
        <translation>読み込み（インポート）ではなく、開いてください。輪郭、穴、合印は切断レイヤーにあり、速度と出力は入っていません。自分の材料ライブラリーから設定してください。溶着線（T1）と描く線（T2）はツールレイヤーにあり、LightBurn が焼くことはありません。</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>開口</translation>
    </message>
    <message>
        <source>Opposite the intake</source>
        <translation>注入口の反対側</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>オレンジ</translation>
    </message>
    <message>
        <source>Order of the seams</source>
        <translation>継ぎ目の順序</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>Outline edit {0} at {1} is left out. {2}</source>
        <translation>輪郭の編集 {0}（{1}）を省きました。{2}</translation>
    </message>
    <message>
        <source>Outline edit {0} does none of {1}. {2}</source>
        <translation>輪郭の編集 {0} は {1} のどれでもありません。{2}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an 'at' that does not fit. {1}</source>
        <translation>輪郭の編集 {0} の 'at' が正しくありません。{1}</translation>
    </message>
    <message>
        <source>Outline edit {0} has an unknown '{1}'. Use {2}.</source>
        <translation>輪郭の編集 {0} に不明な '{1}' があります。{2} を使ってください。</translation>
    </message>
    <message>
        <source>Outline edit {0} has no place [x, y] as its 'to', or one too many. {1}</source>
        <translation>輪郭の編集 {0} の 'to' に位置 [x, y] がないか、余分にあります。{1}</translation>
    </message>
    <message>
        <source>Outline edit {0}: 'mirrored' is true or false.</source>
        <translation>輪郭の編集 {0}：'mirrored' は true か false です。</translation>
    </message>
    <message>
        <source>Outline {}</source>
        <translation>輪郭 {}</translation>
    </message>
    <message>
        <source>Outline {}, holes: {}</source>
        <translation>輪郭 {}、穴：{} 個</translation>
    </message>
    <message>
        <source>Overcut</source>
        <translation>オーバーカット</translation>
    </message>
    <message>
        <source>PDF files, previews and labels need it; DXF, SVG and HPGL can be written.</source>
        <translation>PDFファイル、プレビュー、ラベルに必要です。DXF、SVG、HPGLは書き出せます。</translation>
    </message>
    <message>
        <source>PNG, JPEG or BMP</source>
        <translation>PNG、JPEG、BMP</translation>
    </message>
    <message>
        <source>Pa, its own range</source>
        <translation>Pa（自身の範囲）</translation>
    </message>
    <message>
        <source>Page {0} of {1}: column {2}, row {3}</source>
        <translation>ページ {0}/{1}：{2} 列、{3} 行</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>風船を描く</translation>
    </message>
    <message>
        <source>Paint a shape first: the decoration is seen on it alone.</source>
        <translation>先に形を描いてください。かざりは形の上にだけ見えます。</translation>
    </message>
    <message>
        <source>Paint both sides at once, mirrored (M)</source>
        <translation>左右対称に同時に描く（M）</translation>
    </message>
    <message>
        <source>Paint broad, soft strokes: what is painted becomes a balloon.</source>
        <translation>太く柔らかい線で塗ります。塗ったところが風船になります。</translation>
    </message>
    <message>
        <source>Paint so many times around a centre ( , fewer, . more)</source>
        <translation>中心のまわりに何回描くか（ , で減らし、. で増やす）</translation>
    </message>
    <message>
        <source>Paint something first: a closed line is enough.</source>
        <translation>先に何か描いてください。閉じた線 1 本で十分です。</translation>
    </message>
    <message>
        <source>Paint what becomes the outline (D)</source>
        <translation>輪郭になる形を描く（D）</translation>
    </message>
    <message>
        <source>Paint what is printed on the film and leaves the outline as it is (D)</source>
        <translation>フィルムに印刷する絵を描く。輪郭は変わりません（D）</translation>
    </message>
    <message>
        <source>Painted balloon</source>
        <translation>描いた風船</translation>
    </message>
    <message>
        <source>Painted fish</source>
        <translation>描いた魚</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses itself: divide the body otherwise there.</source>
        <translation>パネル 「{0}」 が自分と交わります。そこで立体の分け方を変えてください。</translation>
    </message>
    <message>
        <source>Panel '{0}' crosses or nearly touches itself: separate the parts that meet there.</source>
        <translation>パネル「{0}」が自分と交わるか、ほとんど接しています。そこで出会う部分を離してください。</translation>
    </message>
    <message>
        <source>Panel '{0}' is folded over: {1} crosses or touches another edge at {2}. Separate them.</source>
        <translation>パネル「{0}」が折り重なっています。{1} が {2} で別の辺と交わるか接しています。離してください。</translation>
    </message>
    <message>
        <source>Panel '{0}' is only {1} wide at {2}, too narrow for welds of {3} along both of its sides. Make it wider, or the welds narrower.</source>
        <translation>パネル「{0}」の幅は {2} で {1} しかなく、両側の幅 {3} の溶着には狭すぎます。広くするか、溶着を細くしてください。</translation>
    </message>
    <message>
        <source>Panel '{0}' is seen from inside: its points run clockwise. Mirror it, or turn their order round.</source>
        <translation>パネル「{0}」が内側から見た向きです。点が時計回りです。反転するか、点の順を逆にしてください。</translation>
    </message>
    <message>
        <source>Panel '{0}' is the whole surface and has no edge: divide the body into more panels.</source>
        <translation>パネル 「{0}」 が表面全体になり、縁がありません。立体をもっと多くのパネルに分けてください。</translation>
    </message>
    <message>
        <source>Panel '{0}' would cross itself when laid flat. {1}</source>
        <translation>パネル「{0}」は平らに広げると自分と交わります。{1}</translation>
    </message>
    <message>
        <source>Panel {0} goes round a part of the body: it is cut open there.</source>
        <translation>パネル {0} は立体の一部を一周しています。そこで切り開きます。</translation>
    </message>
    <message>
        <source>Panel {0} has a triangle with a vertex that is not there. Mesh it anew.</source>
        <translation>パネル{0}に存在しない頂点をもつ三角形があります。メッシュを作り直してください。</translation>
    </message>
    <message>
        <source>Panel {0} has a vertex without triangles. Mesh it anew.</source>
        <translation>パネル{0}に三角形のない頂点があります。メッシュを作り直してください。</translation>
    </message>
    <message>
        <source>Panel {0} has an edge with more than two triangles. Mesh it anew.</source>
        <translation>パネル{0}に3つ以上の三角形をもつ辺があります。メッシュを作り直してください。</translation>
    </message>
    <message>
        <source>Panel {0} has no edge {1} for the opening: say another one of its outer loop.</source>
        <translation>パネル {0} には開口に使う辺 {1} がありません。外側の境界の別の辺を指定してください。</translation>
    </message>
    <message>
        <source>Panel {0} has no room for its name: write it beside the cut when you lay it out.</source>
        <translation>パネル {0} には名前を書く場所がありません。並べるときに切り線の横に書いてください。</translation>
    </message>
    <message>
        <source>Panel {0} has no room for numbers and arrows of seams: {1}. Its notches tell them apart.</source>
        <translation>パネル {0} には継ぎ目の番号と矢印を書く場所がありません：{1}。合印で見分けられます。</translation>
    </message>
    <message>
        <source>Panel {0} is not cut: say another one for the opening.</source>
        <translation>パネル {0} は切り出されません。開口を別のパネルにしてください。</translation>
    </message>
    <message>
        <source>Panel {0} is nowhere wider than {1}, and its welds are {2} wide: it hardly bulges. Make the balloon larger, the panel wider or the seal narrower.</source>
        <translation>パネル {0} の幅は最大でも {1} で、溶着の幅は {2} です。ほとんどふくらみません。風船を大きく、パネルを広く、または溶着を細くしてください。</translation>
    </message>
    <message>
        <source>Panel {0} is open between its vertices {1} and {2}: the boundary is in no seam there. Seal it to another.</source>
        <translation>パネル{0}は頂点{1}と{2}の間が開いています。そこの縁はどの継ぎ目にも入っていません。ほかの縁と接合してください。</translation>
    </message>
    <message>
        <source>Panel {0} leans by {1} between front and back. Make the side band narrower there, or the parts of the drawing wider.</source>
        <translation>パネル {0} が表と裏の間で {1} 傾いています。そこの側面の帯を狭くするか、図の部分を広くしてください。</translation>
    </message>
    <message>
        <source>Panel {0} near {1} goes round the body and cannot be laid flat. Draw a seam across it.</source>
        <translation>{1} 付近のパネル {0} は立体を一周していて、平らに広げられません。それを横切る継ぎ目を描いてください。</translation>
    </message>
    <message>
        <source>Panel {0} of the JSON file has no name or no 'outer' loop. {1}</source>
        <translation>JSON ファイルのパネル {0} に名前か 'outer' の境界がありません。{1}</translation>
    </message>
    <message>
        <source>Panel {0}: an intake of this kind leads through a seam. Say which one, or an edge of the panel such as {1}.0, or choose a nozzle.</source>
        <translation>パネル {0}：この種類の注入口は継ぎ目を通ります。どの継ぎ目か、{1}.0 のような辺を指定するか、ノズルを選んでください。</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>パネル</translation>
    </message>
    <message>
        <source>Panels and seams; a copy of them travels in the document</source>
        <translation>パネルと継ぎ目。写しが文書に入ります</translation>
    </message>
    <message>
        <source>Panels are laid on the film in rows instead of closely; nothing else changes.</source>
        <translation>フィルム片は詰めずに列に並べられます。ほかは変わりません。</translation>
    </message>
    <message>
        <source>Panels laid flat: strained by {0} on average, at most {1}</source>
        <translation>平らに広げたパネル：ひずみは平均 {0}、最大 {1}</translation>
    </message>
    <message>
        <source>Panels with gussets, whose sizes come from a spreadsheet</source>
        <translation>マチ付きのパネル。寸法は表計算シートから</translation>
    </message>
    <message>
        <source>Panels: {0}, of different shapes: {1}</source>
        <translation>パネル：{0} 枚、形の種類：{1}</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>Parts of the balloon may lean to one side or the other: the inflated outline is {0} to {1} from the drawing. Another width of the side band may hold them.</source>
        <translation>風船の一部がどちらかに傾くことがあります。ふくらんだ輪郭は図から {0}～{1} ずれます。側面の帯の幅を変えると安定することがあります。</translation>
    </message>
    <message>
        <source>Paste (Ctrl+V)</source>
        <translation>貼り付け（Ctrl+V）</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>型紙</translation>
    </message>
    <message>
        <source>Pattern correction needs scipy: install it with pip install scipy.</source>
        <translation>型紙の補正には scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Pattern drawn 1 : {0}</source>
        <translation>型紙、縮尺 1 : {0}</translation>
    </message>
    <message>
        <source>Pattern of the balloon, all pieces</source>
        <translation>風船の型紙、すべての部品</translation>
    </message>
    <message>
        <source>Pattern on several pages</source>
        <translation>複数ページの型紙</translation>
    </message>
    <message>
        <source>Pattern written to {}</source>
        <translation>型紙を {} に書き出しました</translation>
    </message>
    <message>
        <source>Pattern {0} ({1} x {2} in), pages: {3}.</source>
        <translation>型紙 {0}（{1} x {2} インチ）、{3} ページ。</translation>
    </message>
    <message>
        <source>Pattern, cut two (one mirrored)</source>
        <translation>型紙（2 枚切り、1 枚は反転）</translation>
    </message>
    <message>
        <source>Pattern, {0} panels</source>
        <translation>型紙、パネル {0} 枚</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>型紙</translation>
    </message>
    <message>
        <source>Patterns need shapely: install it with pip install shapely.</source>
        <translation>型紙には shapely が必要です。pip install shapely で入れてください。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Pen drawing</source>
        <translation>線画</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>写真</translation>
    </message>
    <message>
        <source>Pick an edge to see its partner.</source>
        <translation>辺を選ぶと相手の辺が示されます。</translation>
    </message>
    <message>
        <source>Pick an edge, then its partner, here or in the 3D view. Free edges: {}</source>
        <translation>辺を選び、次に相手の辺を選びます（ここか 3D ビュー）。空いている辺：{}</translation>
    </message>
    <message>
        <source>Pick the edge at which it is filled.</source>
        <translation>空気を入れる辺を選んでください。</translation>
    </message>
    <message>
        <source>Picture (PNG)</source>
        <translation>画像 (PNG)</translation>
    </message>
    <message>
        <source>Picture, SVG, DXF or JSON</source>
        <translation>画像、SVG、DXF、JSON</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Pictures are read by Qt and traced with SciPy instead, a little slower.</source>
        <translation>画像は代わりにQtで読み込み、SciPyでトレースします。少し遅くなります。</translation>
    </message>
    <message>
        <source>Pictures need OpenCV or SciPy: install the package python3-opencv or python3-scipy.</source>
        <translation>画像にはOpenCVまたはSciPyが必要です。パッケージpython3-opencvまたはpython3-scipyをインストールしてください。</translation>
    </message>
    <message>
        <source>Pictures need OpenCV, which is missing or does not work here. Install the package python3-opencv (or opencv-python-headless), or open the picture inside FreeCAD.</source>
        <translation>画像には OpenCV が必要ですが、ないか動きません。python3-opencv（または opencv-python-headless）を入れるか、FreeCAD の中で画像を開いてください。</translation>
    </message>
    <message>
        <source>Pictures of the work</source>
        <translation>作業の図</translation>
    </message>
    <message>
        <source>Pieces of the side band cannot be {0} long. Give 0 or more.</source>
        <translation>側面の帯の 1 本を {0} にはできません。0 以上にしてください。</translation>
    </message>
    <message>
        <source>Pieces of {0} are too short for a side band of {1}. Allow longer ones.</source>
        <translation>{0} の帯は幅 {1} の側面の帯には短すぎます。長くしてください。</translation>
    </message>
    <message>
        <source>Pieces: {}, on {}, {} used</source>
        <translation>部品：{} 個、フィルム {}、使用率 {}</translation>
    </message>
    <message>
        <source>Pipette</source>
        <translation>スポイト</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>ピクセル</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Place by</source>
        <translation>位置の指定</translation>
    </message>
    <message>
        <source>Place on the seam</source>
        <translation>溶着線上の位置</translation>
    </message>
    <message>
        <source>Places of a seam</source>
        <translation>縫い目の位置</translation>
    </message>
    <message>
        <source>Places on the body in mm: two for a cut, one for the chosen seam to be moved to</source>
        <translation>立体上の位置（mm）：切るなら 2 つ、選んだ継ぎ目を動かすなら移す先の 1 つ</translation>
    </message>
    <message>
        <source>Plain PET does not weld to itself: take a grade with a sealing layer, or tape. The aluminium (some 50 nm) adds neither stiffness nor weight. What shops sell as Mylar balloons is mostly nylon-foil.</source>
        <translation>素の PET どうしは溶着できません。シール層のある品種かテープを使います。アルミ（約 50 nm）は硬さにも重さにもほとんど影響しません。店でマイラー風船と呼ばれるものは、たいてい nylon-foil です。</translation>
    </message>
    <message>
        <source>Plain paper (PDF)</source>
        <translation>普通紙（PDF）</translation>
    </message>
    <message>
        <source>Plain shell</source>
        <translation>単純なシェル</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Play the inflation, or stop at a frame</source>
        <translation>膨張を再生する、または途中で止める</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>グラフの縦軸</translation>
    </message>
    <message>
        <source>Plotter units of 0.025 mm. Pen 1 draws the control bar, pen 2 cuts the notches, pen 3 the rest. Nothing is in the file that may not be cut. For a swivel knife set its offset, 0.25 mm is common. Cuts run 1 mm past their start: set overcut_mm to 0 where the cutter does that itself.</source>
        <translation>プロッター単位は 0.025 mm です。ペン 1 は確認用の棒を描き、ペン 2 は合印、ペン 3 は残りを切ります。切ってはいけない線はファイルに入っていません。回転刃ではオフセットを設定してください（普通 0.25 mm）。切り線は始点を 1 mm 越えます。カッターが自分で越えて切るなら overcut_mm を 0 にしてください。</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's 'profile' is not a pair of numbers. {1}</source>
        <translation>JSON ファイルの 'profile' の点 {0} が 2 つの数ではありません。{1}</translation>
    </message>
    <message>
        <source>Point {0} of the JSON file's {1} is not a pair of numbers. {2}</source>
        <translation>JSON ファイルの {1} の点 {0} は数の組ではありません。{2}</translation>
    </message>
    <message>
        <source>Poisson's ratio</source>
        <translation>ポアソン比</translation>
    </message>
    <message>
        <source>Polyethylene film (LDPE), 50 µm</source>
        <translation>ポリエチレンフィルム（LDPE）、50 µm</translation>
    </message>
    <message>
        <source>Polylines at the real size with a layer and a colour for each role. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>原寸のポリライン。役割ごとにレイヤーと色があります。CUT、CUT_INNER、NOTCH は切り、SEAL と WELD は溶着し、ほかはすべて描きます。</translation>
    </message>
    <message>
        <source>Polylines in millimetres with a layer for each role: what every program reads. CUT, CUT_INNER and NOTCH are cut, SEAL and WELD welded, all others drawn.</source>
        <translation>ミリメートルのポリライン。役割ごとのレイヤーで、どのプログラムでも読めます。CUT、CUT_INNER、NOTCH は切り、SEAL と WELD は溶着し、ほかはすべて描きます。</translation>
    </message>
    <message>
        <source>Pouch</source>
        <translation>マチ付き袋</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>Predicted from the outline; not inflated yet.</source>
        <translation>輪郭からの予測です。まだふくらませていません。</translation>
    </message>
    <message>
        <source>Press a head to sort by it.</source>
        <translation>列の見出しを押すと並べ替えます。</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>圧力</translation>
    </message>
    <message>
        <source>Pressure inside, above that outside</source>
        <translation>内圧（外気圧との差）</translation>
    </message>
    <message>
        <source>Pressure rises with height</source>
        <translation>圧力は高いほど大きい</translation>
    </message>
    <message>
        <source>Pressure with the margin left</source>
        <translation>余裕の残る圧力</translation>
    </message>
    <message>
        <source>Pressure: {0}</source>
        <translation>圧力：{0}</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>印刷</translation>
    </message>
    <message>
        <source>Print at 100 % ("actual size"). The bar below must be 100 mm long.</source>
        <translation>100 %（「実際のサイズ」）で印刷してください。下の棒は 100 mm でなければなりません。</translation>
    </message>
    <message>
        <source>Print shop (PDF with CutContour)</source>
        <translation>印刷業者（CutContour 入り PDF）</translation>
    </message>
    <message>
        <source>Print the pieces</source>
        <translation>部品を印刷</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, all panels</source>
        <translation>印刷 {0}、{1} dpi、全パネル</translation>
    </message>
    <message>
        <source>Print {0} at {1} dpi, front and back</source>
        <translation>印刷 {0}、{1} dpi、表と裏</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Pull a line; then move the pointer to bend it, and click. A right click keeps it straight.</source>
        <translation>線を引き、ポインターを動かして曲げ、クリックします。右クリックなら真っすぐのままです。</translation>
    </message>
    <message>
        <source>Pull a rectangle to copy (Ctrl+C) or cut (Ctrl+X); without one that is all. Ctrl+V pastes.</source>
        <translation>四角で囲んでコピー（Ctrl+C）や切り取り（Ctrl+X）をします。囲まなければ全体です。Ctrl+V で貼り付けます。</translation>
    </message>
    <message>
        <source>Pull a shape to its size, up or down to turn it; Shift keeps it upright.</source>
        <translation>引いて形の大きさを決めます。上や下に引くと回ります。Shift を押すと真っすぐのままです。</translation>
    </message>
    <message>
        <source>Pull it, its corner, or the ring that turns it. Enter paints it, Esc drops it.</source>
        <translation>引いて動かし、角で大きさを変え、輪で回します。Enter で描き、Esc でやめます。</translation>
    </message>
    <message>
        <source>Pull the centre of the symmetry to its place, and turn its axis by the ring</source>
        <translation>対称の中心を引いて動かし、輪を引いて軸を回します</translation>
    </message>
    <message>
        <source>Pull the paper. The middle button, or the space bar, does it with every tool; the wheel zooms.</source>
        <translation>紙を動かします。どの道具でも中ボタンかスペースキーで動かせ、ホイールで拡大縮小します。</translation>
    </message>
    <message>
        <source>Pull the straw out and seal straight across the neck, beside the balloon.</source>
        <translation>ストローを抜き、風船のそばで首を真横に溶着します。</translation>
    </message>
    <message>
        <source>Push a straw in, fill, pull it out and close the neck like the seam, straight across beside the balloon.</source>
        <translation>ストローを差し込んでふくらませ、抜いてから、風船のそばで首を真横に、継ぎ目と同じやり方で閉じます。</translation>
    </message>
    <message>
        <source>Push the nozzle through the hole of the front panel from inside, put the ring over it from outside, and join flange, film and ring like the seam, along the ring's line, before the panels are joined.</source>
        <translation>ノズルを表側フィルムの穴に内側から通し、外側から輪をかぶせ、表裏を合わせる前に、フランジ、フィルム、輪を輪の線に沿って、継ぎ目と同じやり方で接合します。</translation>
    </message>
    <message>
        <source>Put a picture on the paper, without its background</source>
        <translation>背景を除いた画像を紙に置く</translation>
    </message>
    <message>
        <source>Put outline, balloon and pattern into the document, and print the pattern</source>
        <translation>輪郭、風船、型紙を文書に入れ、型紙を印刷する</translation>
    </message>
    <message>
        <source>Put the intake low</source>
        <translation>注入口を低い所に付ける</translation>
    </message>
    <message>
        <source>Put the same moves into the document, as objects of FreeCAD's workbench Path (CAM since 1.0), which can simulate them and write them with its post processors</source>
        <translation>同じ動きを、FreeCAD の Path ワークベンチ（1.0 からは CAM）のオブジェクトとして文書に入れる。そこでシミュレーションや、ポストプロセッサーでの書き出しができる</translation>
    </message>
    <message>
        <source>RDWorks (Ruida laser)</source>
        <translation>RDWorks（Ruida レーザー）</translation>
    </message>
    <message>
        <source>Reading a mesh needs scipy: install it with pip install scipy.</source>
        <translation>メッシュを読むには scipy が必要です: pip install scipy でインストールしてください。</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>読む形式</translation>
    </message>
    <message>
        <source>Ready body</source>
        <translation>既製の立体</translation>
    </message>
    <message>
        <source>Ready to make. Paint on, or press Make it!</source>
        <translation>作れます。続けて描くか「作る！」を押してください。</translation>
    </message>
    <message>
        <source>Real size, to cut out by hand. Print at 100 % and measure the control bar.</source>
        <translation>手で切るための原寸です。100 % で印刷し、確認用の棒を測ってください。</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直し</translation>
    </message>
    <message>
        <source>Redo (Ctrl+Y)</source>
        <translation>やり直し（Ctrl+Y）</translation>
    </message>
    <message>
        <source>Remnant</source>
        <translation>残材</translation>
    </message>
    <message>
        <source>Remnants</source>
        <translation>残材</translation>
    </message>
    <message>
        <source>Remove (Del)</source>
        <translation>消す (Del)</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>直す</translation>
    </message>
    <message>
        <source>Repair {0} cannot be read: delete it from Repairs.</source>
        <translation>修正 {0} を読めません。Repairs から消してください。</translation>
    </message>
    <message>
        <source>Replace the file</source>
        <translation>ファイルを置き換える</translation>
    </message>
    <message>
        <source>Replace the files</source>
        <translation>既存のファイルを置き換える</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>Result that is shown as colours, with a legend</source>
        <translation>凡例付きで色表示する結果</translation>
    </message>
    <message>
        <source>Results cannot be written as '{0}'. Choose {1}.</source>
        <translation>結果を「{0}」で書き出すことはできません。{1} を選んでください。</translation>
    </message>
    <message>
        <source>Results written to {}</source>
        <translation>結果を {} に書き出しました</translation>
    </message>
    <message>
        <source>Rim</source>
        <translation>縁</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>輪</translation>
    </message>
    <message>
        <source>Ring that kinks where its weld creases</source>
        <translation>溶着線にしわが寄ると折れ曲がる輪</translation>
    </message>
    <message>
        <source>Ring that warps</source>
        <translation>ねじれる輪</translation>
    </message>
    <message>
        <source>Roland with crop marks (vinyl cutter)</source>
        <translation>クロップマーク対応の Roland（カッティングマシン）</translation>
    </message>
    <message>
        <source>Round pieces up to</source>
        <translation>タブを付ける部品の上限</translation>
    </message>
    <message>
        <source>Round this hole the balloon may kink: with a weld creased to {percent} of its stiffness the outline moves by up to {length}; with one {wanted} wide, creased as much, by {less}.</source>
        <translation>この穴のまわりで風船が折れ曲がることがあります。溶着線がしわで剛性の {percent} しか保たないと、輪郭が最大 {length} 動きます。幅 {wanted} の溶着線なら、同じだけしわが寄っても {less} です。</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie flat: a closed tube wants to curve more and twists out of its plane, here by about {length}. Open the ring, or seal the hole's area without cutting it out and keep it small.</source>
        <translation>この穴のまわりで風船は平らになりません。閉じた管は余計に曲がろうとして面から {length} ほどねじれ出ます。輪を切り開くか、穴を切り抜かずに溶着し、小さくしてください。</translation>
    </message>
    <message>
        <source>Round this hole the balloon will not lie quite flat: a closed tube wants to curve more and twists out of its plane, here by about {length}.</source>
        <translation>この穴のまわりで風船は完全には平らになりません。閉じた管は余計に曲がろうとして面から {length} ほどねじれ出ます。</translation>
    </message>
    <message>
        <source>Round with a radius of</source>
        <translation>丸める半径</translation>
    </message>
    <message>
        <source>Row {0}: {1}</source>
        <translation>{0} 行：{1}</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>行</translation>
    </message>
    <message>
        <source>Rows from below: {0}</source>
        <translation>下からの行: {0}</translation>
    </message>
    <message>
        <source>Rows: {0}, of these make no sense: {1}</source>
        <translation>行：{0}、うち意味をなさない行：{1}</translation>
    </message>
    <message>
        <source>Rows: {0}, without a balloon: {1}</source>
        <translation>行：{0}、風船のない行：{1}</translation>
    </message>
    <message>
        <source>S at full power</source>
        <translation>最大出力の S 値</translation>
    </message>
    <message>
        <source>STL, OBJ, PLY, 3MF or STEP</source>
        <translation>STL、OBJ、PLY、3MF、STEP</translation>
    </message>
    <message>
        <source>SVG files can be written but not read without it; pictures, DXF and JSON can be read.</source>
        <translation>これがないと SVG は書けますが読めません。画像、DXF、JSON は読めます。</translation>
    </message>
    <message>
        <source>SVG files need the Python package svgelements. Install it with 'pip install svgelements', or save the drawing as DXF.</source>
        <translation>SVG ファイルには Python パッケージ svgelements が必要です。「pip install svgelements」で入れるか、図を DXF で保存してください。</translation>
    </message>
    <message>
        <source>SVG, DXF or JSON</source>
        <translation>SVG、DXF、JSON</translation>
    </message>
    <message>
        <source>Safe pressure</source>
        <translation>安全な圧力</translation>
    </message>
    <message>
        <source>Safe pressure: {0}</source>
        <translation>安全な圧力：{0}</translation>
    </message>
    <message>
        <source>Safe pressure: {0}, less than its {1}</source>
        <translation>安全な圧力：{0}、現在の {1} 未満</translation>
    </message>
    <message>
        <source>Safe to</source>
        <translation>安全な圧力</translation>
    </message>
    <message>
        <source>Samples need scipy: install it with pip install scipy.</source>
        <translation>サンプルには scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Samples of a {0} need scipy: install it with pip install scipy, or take {1} ones.</source>
        <translation>{0} のサンプルには scipy が必要です。pip install scipy で入れるか、{1} にしてください。</translation>
    </message>
    <message>
        <source>Samples: {0}, of these failed: {1}, not at rest: {2}</source>
        <translation>サンプル：{0}、うち失敗：{1}、静止せず：{2}</translation>
    </message>
    <message>
        <source>Save as GIF or MP4</source>
        <translation>GIF または MP4 で保存</translation>
    </message>
    <message>
        <source>Save files…</source>
        <translation>ファイルを保存…</translation>
    </message>
    <message>
        <source>Save results</source>
        <translation>結果を保存</translation>
    </message>
    <message>
        <source>Save results…</source>
        <translation>結果を保存…</translation>
    </message>
    <message>
        <source>Save the inflation</source>
        <translation>ふくらみの動画を保存</translation>
    </message>
    <message>
        <source>Scale to fit</source>
        <translation>収まるように縮める</translation>
    </message>
    <message>
        <source>Scaled to fit: the balloon is {0} wide instead of {1}.</source>
        <translation>収まるように縮めました。風船の幅は {1} でなく {0} です。</translation>
    </message>
    <message>
        <source>Scaled to fit: the drawing is {0} wide instead of {1}.</source>
        <translation>収まるように縮めました：図の幅は {1} から {0} になりました。</translation>
    </message>
    <message>
        <source>Scaled to fit: {} wide instead of {}.</source>
        <translation>収まるように縮めました：幅は {1} から {0} になりました。</translation>
    </message>
    <message>
        <source>SciPy triangulates instead, a little slower.</source>
        <translation>代わりに SciPy がメッシュを作ります。少し遅くなります。</translation>
    </message>
    <message>
        <source>Seal a disc on each point where four panels or more meet.</source>
        <translation>4 枚以上のパネルが集まる点には、それぞれ円板を溶着します。</translation>
    </message>
    <message>
        <source>Seal across the neck along its line, through panels and strips. The field keeps the channel open.</source>
        <translation>首を横切る線に沿って、パネルと帯を一緒に溶着します。印の枠が通り道を開けておきます。</translation>
    </message>
    <message>
        <source>Seal the lines inside.</source>
        <translation>内側の線を溶着します。</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all but the mouth of the neck.</source>
        <translation>首の口を残して、輪郭を幅 {seal} で溶着します。</translation>
    </message>
    <message>
        <source>Seal the outline, {seal} wide, all the way round.</source>
        <translation>輪郭を幅 {seal} で、ぐるりと 1 周溶着します。</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end.</source>
        <translation>図の順に、破線に沿って幅 {seal} で端から端まで継ぎ目を溶着します。</translation>
    </message>
    <message>
        <source>Seal the seams in the order of the pictures along the dashed line, {seal} wide, from end to end. Leave the mouth of the neck open.</source>
        <translation>図の順に、破線に沿って幅 {seal} で端から端まで継ぎ目を溶着します。注入口の口は開けておきます。</translation>
    </message>
    <message>
        <source>Seal width</source>
        <translation>溶着幅</translation>
    </message>
    <message>
        <source>Seal width (0: the film's)</source>
        <translation>溶着幅（0：フィルムの値）</translation>
    </message>
    <message>
        <source>Seam</source>
        <translation>継ぎ目</translation>
    </message>
    <message>
        <source>Seam edit {0}</source>
        <translation>継ぎ目の変更 {0}</translation>
    </message>
    <message>
        <source>Seam length</source>
        <translation>継ぎ目の長さ</translation>
    </message>
    <message>
        <source>Seam length: {0}</source>
        <translation>継ぎ目の長さ：{0}</translation>
    </message>
    <message>
        <source>Seam or edge</source>
        <translation>継ぎ目または辺</translation>
    </message>
    <message>
        <source>Seam {0} has no length: it begins and ends where {1} begins. Give two points; a whole loop is written as two seams.</source>
        <translation>継ぎ目 {0} に長さがありません。{1} の始まる所で始まり、終わっています。2 つの点を指定してください。境界全体は 2 つの継ぎ目として書きます。</translation>
    </message>
    <message>
        <source>Seam {0} is along a panel {1}, but there are {2}.</source>
        <translation>継ぎ目{0}はパネル{1}に沿っていますが、パネルは{2}枚です。</translation>
    </message>
    <message>
        <source>Seam {0} is along vertices that panel {1} does not have.</source>
        <translation>継ぎ目{0}はパネル{1}にない頂点に沿っています。</translation>
    </message>
    <message>
        <source>Seam {0} is at an end that stays open: say another one for the opening.</source>
        <translation>継ぎ目 {0} は開いたままの端にあります。開口を別の継ぎ目にしてください。</translation>
    </message>
    <message>
        <source>Seam {0} is on hole {1} of panel '{2}', which has {3}. Check its sides.</source>
        <translation>継ぎ目 {0} がパネル「{2}」の穴 {1} にありますが、穴の数は {3} です。両側を確かめてください。</translation>
    </message>
    <message>
        <source>Seam {0} is on panel {1}, but there are {2}. Check its sides.</source>
        <translation>継ぎ目 {0} がパネル {1} にありますが、パネルは {2} 枚です。両側を確かめてください。</translation>
    </message>
    <message>
        <source>Seam {0} is on point {1} of panel '{2}', whose points there are 0 to {3}. Check its sides.</source>
        <translation>継ぎ目 {0} がパネル「{2}」の点 {1} にありますが、点の番号は 0～{3} です。両側を確かめてください。</translation>
    </message>
    <message>
        <source>Seam {0} joins holes of panels {1} and {2}, where no intake can be: say another seam.</source>
        <translation>継ぎ目 {0} はパネル {1} と {2} の穴をつないでいて、注入口を置けません。別の継ぎ目にしてください。</translation>
    </message>
    <message>
        <source>Seam {0} joins the outside of the film to its inside, as in a Moebius strip. Turn one of its sides round.</source>
        <translation>継ぎ目{0}はメビウスの帯のようにフィルムの表と裏をつないでいます。片側の向きを逆にしてください。</translation>
    </message>
    <message>
        <source>Seam {0} joins {1} vertices to {2}. Divide both sides into equally many parts.</source>
        <translation>継ぎ目{0}は{1}個の頂点を{2}個とつないでいます。両側を同じ数に分けてください。</translation>
    </message>
    <message>
        <source>Seam {0} leaves the boundary of panel {1}. Give its vertices in a row along it.</source>
        <translation>継ぎ目{0}がパネル{1}の縁から外れています。縁に沿って順に頂点を指定してください。</translation>
    </message>
    <message>
        <source>Seam {0} of panels {1} is {2} long, and the intake takes {3} with its welds: make it narrower, or say another edge for the opening.</source>
        <translation>パネル {1} の継ぎ目 {0} の長さは {2} で、注入口は溶着を含めて {3} 必要です。注入口を細くするか、開口を別の辺にしてください。</translation>
    </message>
    <message>
        <source>Seam {0} of the JSON file has no two sides 'a' and 'b'. {1}</source>
        <translation>JSON ファイルの継ぎ目 {0} に 2 つの側 'a' と 'b' がありません。{1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list does none of {1}. {2}</source>
        <translation>一覧の継ぎ目 {0} は {1} のどれでもありません。{2}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has a place that is not [x, y, z]. {1}</source>
        <translation>一覧の継ぎ目 {0} に [x, y, z] でない位置があります。{1}</translation>
    </message>
    <message>
        <source>Seam {0} of the list has an unknown '{1}'. Use {2}.</source>
        <translation>一覧の継ぎ目 {0} に不明な '{1}' があります。{2} を使ってください。</translation>
    </message>
    <message>
        <source>Seam {0} of the list: 'side' is '{1}' or '{2}', 'mirrored' is true or false.</source>
        <translation>一覧の継ぎ目 {0}：'side' は '{1}' か '{2}'、'mirrored' は true か false です。</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last, with the opening.</source>
        <translation>継ぎ目 {0}：{1} と {2}、最後に、開口とともに。</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, last.</source>
        <translation>継ぎ目 {0}：{1} と {2}、最後に。</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, lying flat.</source>
        <translation>継ぎ目 {0}：{1} と {2}、平らに。</translation>
    </message>
    <message>
        <source>Seam {0}: {1} to {2}, one edge turned round the other.</source>
        <translation>継ぎ目 {0}：{1} と {2}、片方の辺を折り返して。</translation>
    </message>
    <message>
        <source>Seam {}: {}</source>
        <translation>継ぎ目 {}：{}</translation>
    </message>
    <message>
        <source>Seam {}: {}; {}</source>
        <translation>シーム {}: {}、{}</translation>
    </message>
    <message>
        <source>Seams</source>
        <translation>継ぎ目</translation>
    </message>
    <message>
        <source>Seams and centres apart</source>
        <translation>継ぎ目と中央の差</translation>
    </message>
    <message>
        <source>Seams and middles of gores: {0} apart at most</source>
        <translation>継ぎ目とゴアの中央の差：最大 {0}</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Seal them bit by bit.</source>
        <translation>平らに重ならない継ぎ目：{0}。少しずつ溶着してください。</translation>
    </message>
    <message>
        <source>Seams that do not lie flat: {0}. Their allowance is cut into tabs that turn.</source>
        <translation>平らに重ならない継ぎ目：{0}。縫い代はタブに切ってあり、折り返します。</translation>
    </message>
    <message>
        <source>Seams {0} and {1} hold the same piece of the boundary of panel {2}. Seal each piece once.</source>
        <translation>継ぎ目{0}と{1}がパネル{2}の縁の同じ部分を使っています。各部分は一度だけ接合してください。</translation>
    </message>
    <message>
        <source>Seams: {0}, where an edge must turn: {1}</source>
        <translation>継ぎ目：{0}、うち辺を折り返すもの：{1}</translation>
    </message>
    <message>
        <source>Second panel, mirrored</source>
        <translation>2 枚目（反転）</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Select a sketch of half the outline, or choose where the profile comes from.</source>
        <translation>輪郭の半分のスケッチか、断面の出どころを選んでください。</translation>
    </message>
    <message>
        <source>Select a sketch, a wire or a face in the tree or the 3D view.</source>
        <translation>ツリーか 3D ビューでスケッチ、ワイヤー、面を選んでください。</translation>
    </message>
    <message>
        <source>Select a solid or a mesh, or choose a file.</source>
        <translation>ソリッドかメッシュを選択するか、ファイルを選んでください。</translation>
    </message>
    <message>
        <source>Select all (Ctrl+A)</source>
        <translation>すべて選択（Ctrl+A）</translation>
    </message>
    <message>
        <source>Select another</source>
        <translation>選び直す</translation>
    </message>
    <message>
        <source>Select sketches or flat faces, or take a ready body or a file.</source>
        <translation>スケッチか平らな面を選ぶか、既製の立体かファイルを使ってください。</translation>
    </message>
    <message>
        <source>Select sketches, wires or flat faces first.</source>
        <translation>先にスケッチ、ワイヤー、平らな面を選んでください。</translation>
    </message>
    <message>
        <source>Self-sealing film valve</source>
        <translation>自動で閉じるフィルム弁</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. A laser wants laser mode, $32=1.</source>
        <translation>フィルムの左下の角を X0 Y0、工具がフィルムに触れる高さを Z0 にしてください。ファイルは原点復帰をしません。レーザーではレーザーモード（$32=1）にしてください。</translation>
    </message>
    <message>
        <source>Set X0 Y0 at the lower left corner of the film, and Z0 where the tool touches it; nothing homes. For a swivel knife set its offset in a machine file of your own.</source>
        <translation>フィルムの左下の角を X0 Y0、工具がフィルムに触れる高さを Z0 にしてください。ファイルは原点復帰をしません。回転刃では、自分の機械のファイルでオフセットを設定してください。</translation>
    </message>
    <message>
        <source>Set the opening</source>
        <translation>開口を決める</translation>
    </message>
    <message>
        <source>Set up machines of your own</source>
        <translation>自分の機械を設定します</translation>
    </message>
    <message>
        <source>Shadows on the background were taken off.</source>
        <translation>背景の影を取り除きました。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Shape that stays flat</source>
        <translation>平らなままの形</translation>
    </message>
    <message>
        <source>Share of the feed near corners and in narrow bends</source>
        <translation>角の近くやきつい曲がりでの送り速度の割合</translation>
    </message>
    <message>
        <source>Share of the laser's full power; empty: not known yet</source>
        <translation>レーザーの最大出力に対する割合。空ならまだ不明</translation>
    </message>
    <message>
        <source>Sharp or round (S)</source>
        <translation>角か丸か (S)</translation>
    </message>
    <message>
        <source>Sheet length</source>
        <translation>シートの長さ</translation>
    </message>
    <message>
        <source>Sheet {} of {}</source>
        <translation>シート {}/{}</translation>
    </message>
    <message>
        <source>Show all (0)</source>
        <translation>全体を表示 (0)</translation>
    </message>
    <message>
        <source>Show all pieces (0)</source>
        <translation>すべての部品を表示 (0)</translation>
    </message>
    <message>
        <source>Show the drawing and the silhouette over each other</source>
        <translation>図とシルエットを重ねて表示する</translation>
    </message>
    <message>
        <source>Show the whole paper (0)</source>
        <translation>紙全体を表示（0）</translation>
    </message>
    <message>
        <source>Shown on the pieces</source>
        <translation>部品の上の表示</translation>
    </message>
    <message>
        <source>Shown sheet</source>
        <translation>表示するシート</translation>
    </message>
    <message>
        <source>Shown side</source>
        <translation>表示する面</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is not the name of a panel and two points. {2}</source>
        <translation>継ぎ目 {1} の側 '{0}' がパネル名と 2 つの点ではありません。{2}</translation>
    </message>
    <message>
        <source>Side '{0}' of seam {1} is on a panel '{2}' that is not there. {3}</source>
        <translation>継ぎ目 {1} の側 '{0}' が、存在しないパネル「{2}」にあります。{3}</translation>
    </message>
    <message>
        <source>Side band</source>
        <translation>側面の帯</translation>
    </message>
    <message>
        <source>Side {0} of seam {1} runs the wrong way at {2}, which would seal the outside of the film to its inside, as in a Moebius strip: it goes {3} its loop. Swap the two points of {4}.</source>
        <translation>継ぎ目 {1} の側 {0} が {2} で逆向きです。このままではメビウスの帯のようにフィルムの表と裏が溶着されます。境界に対して{3}に進んでいます。{4} の 2 つの点を入れ替えてください。</translation>
    </message>
    <message>
        <source>Silhouette Cameo 5 Alpha from Inkscape</source>
        <translation>Inkscape から Silhouette Cameo 5 Alpha</translation>
    </message>
    <message>
        <source>Silhouette Studio (vinyl cutter)</source>
        <translation>Silhouette Studio（カッティングマシン）</translation>
    </message>
    <message>
        <source>Silhouette error, largest</source>
        <translation>シルエットの誤差、最大</translation>
    </message>
    <message>
        <source>Silhouette error, mean</source>
        <translation>シルエットの誤差、平均</translation>
    </message>
    <message>
        <source>Silhouette from Inkscape</source>
        <translation>Inkscape から Silhouette</translation>
    </message>
    <message>
        <source>Silhouette off the drawing</source>
        <translation>シルエットと図のずれ</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>シミュレーション</translation>
    </message>
    <message>
        <source>Simulations use NumPy. "What works here" in the menu fetches the native solver later.</source>
        <translation>シミュレーションには NumPy を使います。ネイティブソルバーは、後でメニューの「この環境で使えるもの」から取得できます。</translation>
    </message>
    <message>
        <source>Six gores from half an outline in a sketch: change their number</source>
        <translation>スケッチの輪郭の半分から 6 枚のゴア：数を変えてみてください</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Size from</source>
        <translation>大きさの決め方</translation>
    </message>
    <message>
        <source>Size unknown</source>
        <translation>大きさ不明</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>なめらかさ</translation>
    </message>
    <message>
        <source>So far it is a line. Close it, or paint an area, and it becomes a balloon.</source>
        <translation>まだ線です。閉じるか面を塗ると風船になります。</translation>
    </message>
    <message>
        <source>Soft PVC film, 0.2 mm</source>
        <translation>軟質 PVC フィルム、0.2 mm</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>ソルバー</translation>
    </message>
    <message>
        <source>Solver: {0}.</source>
        <translation>ソルバー：{0}。</translation>
    </message>
    <message>
        <source>Solver: {0}. {1}</source>
        <translation>ソルバー：{0}。{1}</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>スピンドル</translation>
    </message>
    <message>
        <source>Split over beds</source>
        <translation>加工台ごとに分ける</translation>
    </message>
    <message>
        <source>Split over beds of {0}, the pattern leaves no waste film for two crosses {1} apart by which it is laid on anew: choose a larger bed, or lay the pieces out on sheets.</source>
        <translation>{0} の加工台ごとに分けると、フィルムを置き直すための十字 2 つを {1} 離して入れるだけの、捨てるフィルムがありません。もっと大きい加工台を選ぶか、部品をシートに並べてください。</translation>
    </message>
    <message>
        <source>Spot in 16 panels</source>
        <translation>16 枚のパネルの Spot</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>スタンプ</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星</translation>
    </message>
    <message>
        <source>Start values for welding: {0} ({1}).</source>
        <translation>溶着の最初に試す値：{0}（{1}）。</translation>
    </message>
    <message>
        <source>Start values, not tried on your film and tool: {start_values} ({start_sources}).</source>
        <translation>最初に試す値（自分のフィルムと工具では未確認）：{start_values}（{start_sources}）。</translation>
    </message>
    <message>
        <source>Stated is: {0} ({1}).</source>
        <translation>示されている値：{0}（{1}）。</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>手順</translation>
    </message>
    <message>
        <source>Stiffer across the web than along it (up to 4.5 against 2.5 GPa): cut both panels in the same direction. Only grades with a sealing layer weld; the gas barrier is poor.</source>
        <translation>流れ方向より直角方向の方が硬い（2.5 に対し最大 4.5 GPa）ので、2 枚を同じ向きに切ってください。溶着できるのはシール層のある品種だけで、気体の遮断性は低めです。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stop (Esc)</source>
        <translation>停止（Esc）</translation>
    </message>
    <message>
        <source>Stop and keep the last result</source>
        <translation>停止して最後の結果を残す</translation>
    </message>
    <message>
        <source>Stopped. Your painting is still here.</source>
        <translation>停止しました。描いた絵は残っています。</translation>
    </message>
    <message>
        <source>Stopping ...</source>
        <translation>停止しています…</translation>
    </message>
    <message>
        <source>Straight from the front, from far away, on a plain background of another colour</source>
        <translation>真正面の遠くから、違う色の無地の背景で撮ったもの</translation>
    </message>
    <message>
        <source>Straw neck</source>
        <translation>ストロー用の首</translation>
    </message>
    <message>
        <source>Stretch of the film: {0}</source>
        <translation>フィルムの伸び：{0}</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>帯</translation>
    </message>
    <message>
        <source>Strips welded together</source>
        <translation>帯どうしを溶着</translation>
    </message>
    <message>
        <source>Studies on Dask need {0}: install it with pip install {1}, or leave --dask and --scheduler out ({2}).</source>
        <translation>Dask でのスタディには {0} が必要です。pip install {1} で入れるか、--dask と --scheduler を外してください（{2}）。</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>スタディ</translation>
    </message>
    <message>
        <source>Such as Tip for PE</source>
        <translation>「PE 用こて先」など</translation>
    </message>
    <message>
        <source>Summa with OPOS (vinyl cutter)</source>
        <translation>OPOS 付き Summa（カッティングマシン）</translation>
    </message>
    <message>
        <source>Summa with OPOS XY (vinyl cutter)</source>
        <translation>OPOS XY 付き Summa（カッティングマシン）</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>TPU-coated nylon fabric (70 den), 170 g/m²</source>
        <translation>TPU コートのナイロン布（70 デニール）、170 g/m²</translation>
    </message>
    <message>
        <source>Tab to tie it to</source>
        <translation>結ぶための耳</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>タブ</translation>
    </message>
    <message>
        <source>Tabs are left by a machine that cuts: give --machine too, and one that does.</source>
        <translation>タブを残すのは切る機械です。切る機械を --machine で指定してください。</translation>
    </message>
    <message>
        <source>Tacked to one panel</source>
        <translation>片方のフィルムに仮留め</translation>
    </message>
    <message>
        <source>Take a colour from the painting, or the picture under it</source>
        <translation>描いた絵か、下絵の画像から色を取る</translation>
    </message>
    <message>
        <source>Take a tool to change the seams, or choose one and press Delete to merge.</source>
        <translation>継ぎ目を変えるツールを選ぶか、継ぎ目を選んで Delete キーで結合してください。</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Take everything off the paper</source>
        <translation>紙の上をすべて消す</translation>
    </message>
    <message>
        <source>Take paint off</source>
        <translation>絵の具を消す</translation>
    </message>
    <message>
        <source>Take seam apart</source>
        <translation>継ぎ目を外す</translation>
    </message>
    <message>
        <source>Take the last change of a seam back (Ctrl+Z in the 3D view)</source>
        <translation>継ぎ目の最後の変更を元に戻す（3D ビューでは Ctrl+Z）</translation>
    </message>
    <message>
        <source>Take the numbers of one of FreeCAD's material cards</source>
        <translation>FreeCAD の材料カードの数値を使う</translation>
    </message>
    <message>
        <source>Take the picture away</source>
        <translation>画像を外す</translation>
    </message>
    <message>
        <source>Take this row</source>
        <translation>この行を採用</translation>
    </message>
    <message>
        <source>Take what is selected</source>
        <translation>選んだものを使う</translation>
    </message>
    <message>
        <source>Take {0} gores.</source>
        <translation>ゴアを {0} 枚にしてください。</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>テープ</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide, all the way round.</source>
        <translation>破線に沿って幅 {seal} で、ぐるりと 1 周テープで留めます。</translation>
    </message>
    <message>
        <source>Tape along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>破線に沿って幅 {seal} でテープで留めます。首の口は開けておきます。</translation>
    </message>
    <message>
        <source>Taped seam</source>
        <translation>テープの継ぎ目</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>目標の立体</translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>Temperatures need scipy: install it with pip install scipy.</source>
        <translation>温度には scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>Tension field</source>
        <translation>張力場</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>テストカード</translation>
    </message>
    <message>
        <source>Test card written to {}</source>
        <translation>テストカードを {} に書き出しました</translation>
    </message>
    <message>
        <source>Test cards</source>
        <translation>テストカード</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>That of the front</source>
        <translation>表と同じ</translation>
    </message>
    <message>
        <source>That of the outline</source>
        <translation>輪郭のもの</translation>
    </message>
    <message>
        <source>That of the page</source>
        <translation>ページと同じ</translation>
    </message>
    <message>
        <source>That wide</source>
        <translation>この幅</translation>
    </message>
    <message>
        <source>That would take {0} pages: choose larger paper or a smaller balloon.</source>
        <translation>{0} ページになってしまいます。大きな用紙か小さな風船にしてください。</translation>
    </message>
    <message>
        <source>The "as_made" of the film {0} cannot be read: delete it from the file.</source>
        <translation>フィルム {0} の「as_made」を読めません。ファイルから消してください。</translation>
    </message>
    <message>
        <source>The 'at' of seam {0} of the list is no list of places. {1}</source>
        <translation>一覧の継ぎ目 {0} の 'at' が位置のリストではありません。{1}</translation>
    </message>
    <message>
        <source>The 'cut' of panel '{0}' is neither true nor false. Write one of them.</source>
        <translation>パネル「{0}」の 'cut' が true でも false でもありません。どちらかを書いてください。</translation>
    </message>
    <message>
        <source>The 'ease' of the JSON file is no part of a length. Give a number from 0 to 1.</source>
        <translation>JSON ファイルの 'ease' が長さの割合ではありません。0～1 の数にしてください。</translation>
    </message>
    <message>
        <source>The 'holes' of panel '{0}' are not a list of loops. {1}</source>
        <translation>パネル「{0}」の 'holes' が境界のリストではありません。{1}</translation>
    </message>
    <message>
        <source>The 'natural_shape' of the JSON file is no length. Give the length of its gores.</source>
        <translation>JSON ファイルの 'natural_shape' が長さではありません。ゴアの長さを書いてください。</translation>
    </message>
    <message>
        <source>The 'opening' of the JSON file has no panel and point. {0}</source>
        <translation>JSON ファイルの 'opening' にパネルと点がありません。{0}</translation>
    </message>
    <message>
        <source>The 'panels' of seam {0} of the list are no names. {1}</source>
        <translation>一覧の継ぎ目 {0} の 'panels' が名前ではありません。{1}</translation>
    </message>
    <message>
        <source>The 'parts' of the JSON file are not a list of shapes. {0}</source>
        <translation>JSON ファイルの 'parts' が形の一覧ではありません。{0}</translation>
    </message>
    <message>
        <source>The 'profile' of the JSON file needs at least two points. {0}</source>
        <translation>JSON ファイルの 'profile' には 2 点以上が必要です。{0}</translation>
    </message>
    <message>
        <source>The '{0}' of the JSON file are not a list of {1}. {2}</source>
        <translation>JSON ファイルの '{0}' が {1} の一覧ではありません。{2}</translation>
    </message>
    <message>
        <source>The '{0}' of the body '{1}' is out of range. Choose {2}.</source>
        <translation>立体「{1}」の '{0}' が範囲の外です。{2} にしてください。</translation>
    </message>
    <message>
        <source>The 3MF file has more than {0} bodies. Leave one of them in it.</source>
        <translation>3MF ファイルの立体が {0} 個を超えています。1 つだけ残してください。</translation>
    </message>
    <message>
        <source>The 3MF file has no bodies. Save the body as a mesh of triangles.</source>
        <translation>3MF ファイルに立体がありません。立体を三角形のメッシュとして保存してください。</translation>
    </message>
    <message>
        <source>The 3MF file is damaged ({}). Save it once more.</source>
        <translation>3MF ファイルが壊れています（{}）。保存し直してください。</translation>
    </message>
    <message>
        <source>The 3MF file is too large. Simplify the mesh in the program it comes from.</source>
        <translation>3MF ファイルが大きすぎます。元のプログラムでメッシュを簡単にしてください。</translation>
    </message>
    <message>
        <source>The DXF file has errors; what could be read was taken from it.</source>
        <translation>DXF ファイルに誤りがあります。読めたものだけを取り込みました。</translation>
    </message>
    <message>
        <source>The DXF file {0}; millimetres are assumed.</source>
        <translation>DXF ファイル：{0}。ミリメートルとして扱います。</translation>
    </message>
    <message>
        <source>The G-code turns the tool by {0}. FreeCAD takes that axis for one that turns the work: its 3D view shows the path turned.</source>
        <translation>この G コードは {0} で工具を回します。FreeCAD はその軸を加工物を回す軸とみなすため、3D ビューではパスが回って見えます。</translation>
    </message>
    <message>
        <source>The JSON file cannot be read ({0}). {1}</source>
        <translation>JSON ファイルを読めません（{0}）。{1}</translation>
    </message>
    <message>
        <source>The JSON file does not name its unit; millimetres are assumed.</source>
        <translation>JSON ファイルに単位がないので、ミリメートルとして扱います。</translation>
    </message>
    <message>
        <source>The JSON file has no 'outer' loop. {0}</source>
        <translation>JSON ファイルに 'outer' がありません。{0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'panels'. {0}</source>
        <translation>JSON ファイルに 'panels' のリストがありません。{0}</translation>
    </message>
    <message>
        <source>The JSON file has no list of 'seams'. {0}</source>
        <translation>JSON ファイルに 'seams' のリストがありません。{0}</translation>
    </message>
    <message>
        <source>The JSON file has the unknown unit {0}. Use one of {1}.</source>
        <translation>JSON ファイルの単位 {0} は不明です。{1} のどれかにしてください。</translation>
    </message>
    <message>
        <source>The JSON file's {0} needs at least {1}. {2}</source>
        <translation>JSON ファイルの {0} には少なくとも {1} 必要です。{2}</translation>
    </message>
    <message>
        <source>The OBJ file has a face that is no list of points. Save it once more.</source>
        <translation>OBJ ファイルに、点の並びでない面があります。保存し直してください。</translation>
    </message>
    <message>
        <source>The OBJ file has no faces. Save the body as a mesh of triangles.</source>
        <translation>OBJ ファイルに面がありません。立体を三角形のメッシュとして保存してください。</translation>
    </message>
    <message>
        <source>The PLY file has no faces. Save the body as a mesh of triangles.</source>
        <translation>PLY ファイルに面がありません。立体を三角形のメッシュとして保存してください。</translation>
    </message>
    <message>
        <source>The PLY file is damaged: {} Save it once more.</source>
        <translation>PLY ファイルが壊れています：{} 保存し直してください。</translation>
    </message>
    <message>
        <source>The Poisson's ratio {0} is not between 0 and 0.5: give one such as 0.38.</source>
        <translation>ポアソン比 {0} は 0 から 0.5 の間にありません。0.38 のように指定してください。</translation>
    </message>
    <message>
        <source>The Python package {0} is missing. {1} To get it: pip install {2}</source>
        <translation>Python パッケージ {0} がありません。{1} 入れるには：pip install {2}</translation>
    </message>
    <message>
        <source>The STL file is damaged, as it ends too early, or no STL file at all. Save it once more.</source>
        <translation>STL ファイルが途中で終わっていて壊れているか、STL ファイルではありません。保存し直してください。</translation>
    </message>
    <message>
        <source>The STL file is damaged: it has no triangles, or half of one. Save it once more.</source>
        <translation>STL ファイルが壊れています。三角形がないか、途中で切れています。保存し直してください。</translation>
    </message>
    <message>
        <source>The SVG file cannot be read ({0}). Save it as plain SVG once more.</source>
        <translation>SVG ファイルを読めません（{0}）。プレーン SVG で保存し直してください。</translation>
    </message>
    <message>
        <source>The SVG file defines entities, which are not read. Save it as plain SVG.</source>
        <translation>SVG ファイルに読み込めないエンティティ定義があります。プレーン SVG で保存してください。</translation>
    </message>
    <message>
        <source>The SVG file has a '{0}' of endless length. Save it as plain SVG once more.</source>
        <translation>SVG ファイルに長さが無限の「{0}」があります。プレーン SVG で保存し直してください。</translation>
    </message>
    <message>
        <source>The SVG file has too many attributes. Save it as plain SVG once more.</source>
        <translation>SVG ファイルの属性が多すぎます。プレーン SVG で保存し直してください。</translation>
    </message>
    <message>
        <source>The SVG file has too many styles. Save it as plain SVG once more.</source>
        <translation>SVG ファイルのスタイルが多すぎます。プレーン SVG で保存し直してください。</translation>
    </message>
    <message>
        <source>The SVG file is damaged ({0}). Save it once more.</source>
        <translation>SVG ファイルが壊れています（{0}）。保存し直してください。</translation>
    </message>
    <message>
        <source>The Young's modulus across the grain {0} is too large for one along it of {1}: turn the grain by 90 degrees and exchange the two.</source>
        <translation>流れに直角のヤング率 {0} は、流れ方向の {1} に対して大きすぎます。流れ方向を 90 度回し、二つを入れ替えてください。</translation>
    </message>
    <message>
        <source>The accuracy decides the number of panels: give one of them.</source>
        <translation>パネルの数は精度で決まります。どちらか一方だけを指定してください。</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.003 is within 0.3 % of the diagonal.</source>
        <translation>精度は 0 より大きく 1 より小さい数です。0.003 は対角線の 0.3 % 以内です。</translation>
    </message>
    <message>
        <source>The accuracy must be above 0 and below 1: 0.01 is within 1 % of the profile.</source>
        <translation>精度は 0 より大きく 1 より小さい数です。0.01 は断面の 1 % 以内です。</translation>
    </message>
    <message>
        <source>The altitude {0} m is out of range: give one up to 11000 m.</source>
        <translation>高度 {0} m は範囲外です。11000 m までにしてください。</translation>
    </message>
    <message>
        <source>The axis that turns the wheel or knife along the path, 0 along X, counter-clockwise from above; none for one that swivels or is round</source>
        <translation>ホイールや刃をパスの向きに回す軸。X 方向が 0 で、上から見て反時計回り。自在に回る工具や丸い工具では「なし」</translation>
    </message>
    <message>
        <source>The bag has no opening through which it is filled. Name the edge at which it stays open, such as edge 1 of panel '{0}', or make it without an intake.</source>
        <translation>袋に空気を入れる開口がありません。開けておく辺（例：パネル「{0}」の辺 1）を指定するか、注入口なしで作ってください。</translation>
    </message>
    <message>
        <source>The bag has {0} panels, more than {1}. Make it of fewer, larger ones.</source>
        <translation>袋のパネルが {0} 枚で、{1} 枚を超えています。大きなパネルを少なくして作ってください。</translation>
    </message>
    <message>
        <source>The balloon</source>
        <translation>風船</translation>
    </message>
    <message>
        <source>The balloon has no opening: say at which edge it is filled, or choose no intake.</source>
        <translation>風船に開口がありません。空気を入れる辺を指定するか、注入口なしを選んでください。</translation>
    </message>
    <message>
        <source>The balloon has nothing that is called '{0}': {1}.</source>
        <translation>風船に「{0}」という名前のものはありません。{1}。</translation>
    </message>
    <message>
        <source>The balloon has parts too thin to fit the film with: use a wider shape.</source>
        <translation>風船に、フィルムを合わせるには細すぎる部分があります。もっと幅の広い形を使ってください。</translation>
    </message>
    <message>
        <source>The balloon is not near rest. Inflate it anew.</source>
        <translation>風船がまだ静止に近づいていません。ふくらませ直してください。</translation>
    </message>
    <message>
        <source>The balloon is nowhere {0} wide behind its intake: choose another intake angle or a narrower intake, else air enters slowly.</source>
        <translation>注入口の奥に幅 {0} の所がありません。別の向きか細い注入口にしないと、空気がゆっくりしか入りません。</translation>
    </message>
    <message>
        <source>The balloon must be thicker than 0, not {0}. Give its thickness.</source>
        <translation>風船の厚さは 0 より大きくなければなりません（今は {0}）。厚さを指定してください。</translation>
    </message>
    <message>
        <source>The balloon of {0} gores is {1} of its diagonal away from the profile on average, and {2} was asked for: its seams stand out by up to {3} over the middle of the gores. {4}</source>
        <translation>ゴア {0} 枚の風船は断面から平均で対角線の {1} ずれています。求められたのは {2} です。継ぎ目がゴアの中央より最大 {3} 外に出ます。{4}</translation>
    </message>
    <message>
        <source>The balloon stays {0} from the body on average, {1} of its diagonal: flat panels bulge between their seams. Take more than {2} panels.</source>
        <translation>風船は立体から平均 {0}（対角線の {1}）離れています。平らなパネルは継ぎ目の間でふくらむためです。パネルを {2} 枚より多くしてください。</translation>
    </message>
    <message>
        <source>The balloon whose weld creases did not come to rest; what is told of it is its last good state.</source>
        <translation>溶着線にしわが寄った風船が静止しませんでした。その数値は最後の良い状態のものです。</translation>
    </message>
    <message>
        <source>The bar of {0} does not fit between marks that are {1} apart: make the balloon larger, or print several beside each other.</source>
        <translation>{1} 離れた印の間に {0} の棒が入りません。風船を大きくするか、いくつか並べて印刷してください。</translation>
    </message>
    <message>
        <source>The bending floor must be between 0 and 1, not {0}. Usual is {1}.</source>
        <translation>曲げ剛性の下限は 0 から 1 の間にしてください（指定は {0}）。通常は {1} です。</translation>
    </message>
    <message>
        <source>The bleed must be from 0 to {0}, not {1}.</source>
        <translation>塗り足しは 0 から {0} までです（指定は {1}）。</translation>
    </message>
    <message>
        <source>The body '{0}' has no '{1}'. It has {2}.</source>
        <translation>立体「{0}」に '{1}' はありません。あるのは {2} です。</translation>
    </message>
    <message>
        <source>The body has no plane of symmetry.</source>
        <translation>立体に対称面がありません。</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.</source>
        <translation>立体に継ぎ目がありません。継ぎ目を描くか、パネルを 2 枚以上にしてください。</translation>
    </message>
    <message>
        <source>The body has no seam. Draw seams, or take 2 panels or more.{0}</source>
        <translation>立体に継ぎ目がありません。継ぎ目を描くか、パネルを 2 枚以上にしてください。{0}</translation>
    </message>
    <message>
        <source>The body has nothing near {0}. Give a place on its surface.</source>
        <translation>{0} 付近に立体がありません。表面上の位置を指定してください。</translation>
    </message>
    <message>
        <source>The body is thinner than {0} over {1} of its surface: film bulges there. Make such parts of two panels of their own, or thicker.</source>
        <translation>立体は表面の {1} で {0} より薄くなっています。そこではフィルムがふくらみます。そのような部分は別の二枚のパネルで作るか、厚くしてください。</translation>
    </message>
    <message>
        <source>The body is {0} long. Give a width or a height, so that it is between {1} and {2}.</source>
        <translation>立体の長さが {0} です。{1}～{2} になるように、幅か高さを指定してください。</translation>
    </message>
    <message>
        <source>The body of the mesh is flat: it encloses {0} % of its size. Give a closed body, or a drawing for two equal panels.</source>
        <translation>メッシュの立体が平らです。囲む体積は大きさの {0} % です。閉じた立体か、同じ 2 枚のパネル用の図を渡してください。</translation>
    </message>
    <message>
        <source>The body of the profile is {0} high and {1} wide: no balloon is so flat. Draw its profile higher, or make it of two panels.</source>
        <translation>断面の立体は高さ {0}、幅 {1} です。これほど平らな風船はできません。断面をもっと高く描くか、2 枚のパネルで作ってください。</translation>
    </message>
    <message>
        <source>The camera finds the dots round a print, on the layer Register; the fifth tells how the sheet lies. The layer Register is not cut.</source>
        <translation>カメラが、レイヤー Register にある印刷のまわりの点を見つけます。5 番目の点はシートの向きを示します。レイヤー Register は切りません。</translation>
    </message>
    <message>
        <source>The caps are too large for the ball. Choose a smaller diameter for them.</source>
        <translation>ボールに対してキャップが大きすぎます。直径を小さくしてください。</translation>
    </message>
    <message>
        <source>The card has no field {0}: choose one of {1}.</source>
        <translation>カードに欄 {0} はありません: {1} から選んでください。</translation>
    </message>
    <message>
        <source>The cluster cannot be made ({0}): check the file that --cluster names.</source>
        <translation>クラスターを作れません（{0}）。--cluster のファイルを確かめてください。</translation>
    </message>
    <message>
        <source>The colour would run out: close the line around this place first.</source>
        <translation>色が外にあふれます。先にこの場所を囲む線を閉じてください。</translation>
    </message>
    <message>
        <source>The connection to {0} ended before the whole native solver had come. Try again. {1}</source>
        <translation>ネイティブソルバーをすべて受け取る前に {0} との接続が切れました。もう一度試してください。{1}</translation>
    </message>
    <message>
        <source>The copied picture</source>
        <translation>コピーした画像</translation>
    </message>
    <message>
        <source>The cutter finds the four discs round a print itself. VersaWorks prints discs of its own: give it the PDF for print and cut instead. The layer REGISTRATION is not cut.</source>
        <translation>カッターが、印刷のまわりの 4 つの円を自分で見つけます。VersaWorks は独自の円を印刷するので、代わりに印刷とカット用の PDF を渡してください。レイヤー REGISTRATION は切りません。</translation>
    </message>
    <message>
        <source>The cutter finds the squares at both sides of a print itself, on the layer Regmark, which is not cut. Set their size of 3 mm and their distances there, where its program does not read them. Feed the sheet with its lower edge first.</source>
        <translation>カッターが、印刷の両側の四角をレイヤー Regmark から自分で見つけます。このレイヤーは切りません。付属のプログラムが読み取らない場合は、カッターで大きさを 3 mm にし、間隔も設定してください。シートは下の縁から先に送ってください。</translation>
    </message>
    <message>
        <source>The drawing cannot be reached everywhere: the silhouette is up to {} off it.</source>
        <translation>図のすべてには届きません。シルエットは最大 {} ずれます。</translation>
    </message>
    <message>
        <source>The drawing has a curve through more than {0} points. Save it as a polyline.</source>
        <translation>図に {0} 個を超える点を通る曲線があります。ポリラインで保存してください。</translation>
    </message>
    <message>
        <source>The drawing has blocks or copies that show themselves. Remove those from it.</source>
        <translation>図に自分自身を含むブロックやコピーがあります。取り除いてください。</translation>
    </message>
    <message>
        <source>The drawing has more than {0} elements, with those of its blocks and copies. Leave only the outline and its holes in it.</source>
        <translation>図の要素が、ブロックやコピーの中も含めて {0} 個を超えています。輪郭と穴だけを残してください。</translation>
    </message>
    <message>
        <source>The drawing has more than {0} groups or blocks inside each other. Take them apart in the program it comes from.</source>
        <translation>図のグループやブロックが {0} 段を超えて入れ子になっています。元のプログラムで分解してください。</translation>
    </message>
    <message>
        <source>The drawing has more than {0} points. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>図の点が {0} 個を超えています。元のプログラムで簡単にするか、輪郭と穴だけを残してください。</translation>
    </message>
    <message>
        <source>The drawing has no closed line. Draw one, and turn texts and groups into paths.</source>
        <translation>図に閉じた線がありません。閉じた線を描き、文字やグループはパスに変換してください。</translation>
    </message>
    <message>
        <source>The drawing has no line. {0}</source>
        <translation>図に線がありません。{0}</translation>
    </message>
    <message>
        <source>The drawing has points more than {0} km from its origin. Move it there, and give it a size between 1 mm and 100 m.</source>
        <translation>図に原点から {0} km 以上離れた点があります。原点へ移し、大きさを 1 mm～100 m にしてください。</translation>
    </message>
    <message>
        <source>The drawing has too much text in its styles and transforms. Save it as plain SVG once more.</source>
        <translation>図のスタイルと変形の記述が多すぎます。プレーン SVG で保存し直してください。</translation>
    </message>
    <message>
        <source>The drawing has {0} lines beside the axis, not one. {1}</source>
        <translation>図には軸の横に線が 1 本ではなく {0} 本あります。{1}</translation>
    </message>
    <message>
        <source>The drawing has {0} shape and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>図の形は {0} 個で、{1} 番はありません。別の Part を選ぶか、この風船を消してください。</translation>
    </message>
    <message>
        <source>The drawing has {0} shapes and no number {1}: choose another Part, or delete this balloon.</source>
        <translation>図の形は {0} 個で、{1} 番はありません。別の Part を選ぶか、この風船を消してください。</translation>
    </message>
    <message>
        <source>The drawing is open: a line starts at {0} and ends {1} away at {2}. Close it.</source>
        <translation>図が閉じていません。{0} で始まる線が、{1} 離れた {2} で終わっています。閉じてください。</translation>
    </message>
    <message>
        <source>The drawing takes more than {0} s to read. Simplify it in the program it comes from, or leave only the outline and its holes in it.</source>
        <translation>図の読み込みに {0} s より長くかかります。元のプログラムで簡単にするか、輪郭と穴だけを残してください。</translation>
    </message>
    <message>
        <source>The drawing was made symmetric: its halves were {0} apart, the left one was kept.</source>
        <translation>図を対称にしました。左右の差は {0} で、左半分を残しました。</translation>
    </message>
    <message>
        <source>The drawing would be smaller than {0}: choose a larger lift.</source>
        <translation>図が {0} より小さくなります。浮力を大きくしてください。</translation>
    </message>
    <message>
        <source>The drawing; a copy of it travels in the document</source>
        <translation>図（コピーが文書に入ります）</translation>
    </message>
    <message>
        <source>The edges of the chosen seam are free again</source>
        <translation>選んだ継ぎ目の辺が自由になりました</translation>
    </message>
    <message>
        <source>The end of a seam cannot be moved alone. Take hold of the seam between its ends.</source>
        <translation>継ぎ目の端だけを動かすことはできません。両端の間をつかんでください。</translation>
    </message>
    <message>
        <source>The error of {0} is of the whole contour: leave "along" out.</source>
        <translation>{0} の誤差は輪郭全体のものです。「along」を外してください。</translation>
    </message>
    <message>
        <source>The error of {0} is per {1}: write "{2}" or "{3}".</source>
        <translation>{0} の誤差は {1} ごとになっています。「{2}」か「{3}」と書いてください。</translation>
    </message>
    <message>
        <source>The faces of {0} cannot be told from each other in a mesh. Repair the solid, or give a mesh of it.</source>
        <translation>{0} の面をメッシュで区別できません。ソリッドを直すか、そのメッシュを渡してください。</translation>
    </message>
    <message>
        <source>The field {0} of this card makes no machine: {1}</source>
        <translation>このカードの欄 {0} は機械になりません: {1}</translation>
    </message>
    <message>
        <source>The file does not name its unit: the largest size in it, {0}, is taken as metres. Give a width to have another one.</source>
        <translation>ファイルに単位が書かれていません。最大の寸法 {0} をメートルとみなします。変えるには幅を指定してください。</translation>
    </message>
    <message>
        <source>The file has no solid that can be read. Save it once more as STEP.</source>
        <translation>ファイルに読み込めるソリッドがありません。STEP で保存し直してください。</translation>
    </message>
    <message>
        <source>The file is XML but no SVG drawing. Choose a drawing.</source>
        <translation>このファイルは XML ですが SVG の図ではありません。図を選んでください。</translation>
    </message>
    <message>
        <source>The file is damaged or not a DXF file. Save it once more.</source>
        <translation>ファイルは壊れているか、DXF ファイルではありません。保存し直してください。</translation>
    </message>
    <message>
        <source>The file of gases {0} is of no use: {1}. Install it anew.</source>
        <translation>気体のファイル {0} が使えません：{1}。入れ直してください。</translation>
    </message>
    <message>
        <source>The file of rules {0} is of no use: {1}. Install it anew.</source>
        <translation>規則のファイル {0} が使えません：{1}。入れ直してください。</translation>
    </message>
    <message>
        <source>The file of the pattern</source>
        <translation>型紙のファイル</translation>
    </message>
    <message>
        <source>The file of what is left of another layout: pieces are laid inside it first</source>
        <translation>別の配置から残ったもののファイル：部品をまずその中に並べます</translation>
    </message>
    <message>
        <source>The file test-card.json that was written with the card</source>
        <translation>カードと一緒に書き出されたファイル test-card.json</translation>
    </message>
    <message>
        <source>The file {0} is of no use: {1}. Install it anew.</source>
        <translation>ファイル {0} が使えません：{1}。入れ直してください。</translation>
    </message>
    <message>
        <source>The files that it, or its program, opens</source>
        <translation>機械、またはそのプログラムが開くファイル</translation>
    </message>
    <message>
        <source>The film '{0}' has no mass. Give its areal density.</source>
        <translation>フィルム「{0}」に質量がありません。面密度を入力してください。</translation>
    </message>
    <message>
        <source>The film came to rest</source>
        <translation>フィルムが静止した</translation>
    </message>
    <message>
        <source>The film comes as near as {0} to the body, and a margin of {1} was asked for. Take more panels, or a larger margin.</source>
        <translation>フィルムは立体に {0} まで近づきますが、指定された余裕は {1} です。パネルを増やすか、余裕を大きくしてください。</translation>
    </message>
    <message>
        <source>The film did not come to rest: its numbers are estimates.</source>
        <translation>フィルムが静止しませんでした。数値は推定です。</translation>
    </message>
    <message>
        <source>The film file {0} calls itself "{1}": give both the same name.</source>
        <translation>フィルムのファイル {0} の中の名前は「{1}」です。同じ名前にしてください。</translation>
    </message>
    <message>
        <source>The film file {0} is of no use: {1}</source>
        <translation>フィルムのファイル {0} が使えません：{1}</translation>
    </message>
    <message>
        <source>The film file {0} lacks {1}: add it.</source>
        <translation>フィルムのファイル {0} に {1} がありません。加えてください。</translation>
    </message>
    <message>
        <source>The film folds up and nothing of it is seen from above: make the shape thicker.</source>
        <translation>フィルムが折りたたまれ、上からは何も見えません。形を太くしてください。</translation>
    </message>
    <message>
        <source>The film lies from {0} to {1} outside of the body</source>
        <translation>フィルムの位置は立体の外側 {0}～{1} です</translation>
    </message>
    <message>
        <source>The film needs a width of more than two spacings, and no spacing below 0.</source>
        <translation>フィルムの幅は間隔の 2 倍より広く、間隔は 0 以上にしてください。</translation>
    </message>
    <message>
        <source>The film of shop-bought foil balloons: 15 µm oriented nylon 6 with an aluminium coat, 15 µm polyethylene inside. Weld PE to PE. Nylon takes up moisture and is then softer.</source>
        <translation>市販の風船のフィルムです。アルミ蒸着した 15 µm の延伸ナイロン 6 と、内側の 15 µm のポリエチレン。PE どうしを溶着します。ナイロンは湿気を吸うと柔らかくなります。</translation>
    </message>
    <message>
        <source>The film passes through itself near {0}, which the simulation does not feel: the balloon will look otherwise there. Move those parts away from each other.</source>
        <translation>フィルムが {0} の近くで自分自身を通り抜けています。シミュレーションはそれを感じないため、実物はそこで違う形になります。その部分を互いに離してください。</translation>
    </message>
    <message>
        <source>The film stays up to {0} away from the profile, even half way between the seams and the middle of the gores: it cannot take this shape. Round the profile where it is flat, hollow or sharp.</source>
        <translation>フィルムは継ぎ目とゴアの中央の中間でも断面から最大 {0} 離れたままで、この形になれません。断面の平ら、くぼみ、とがった所を丸くしてください。</translation>
    </message>
    <message>
        <source>The first {0} of {1} rows, without a balloon: {2}</source>
        <translation>{1} 行のうち最初の {0} 行、風船のない行：{2}</translation>
    </message>
    <message>
        <source>The first {0} rows; the others are in table.csv.</source>
        <translation>最初の {0} 行。残りは table.csv にあります。</translation>
    </message>
    <message>
        <source>The folder '{0}' has vanished: bring it back or choose another one, and start the study again.</source>
        <translation>フォルダー「{0}」がなくなりました。元に戻すか別のフォルダーを選び、スタディをもう一度始めてください。</translation>
    </message>
    <message>
        <source>The free edition opens DXF, not SVG. Choose "as is" for the size in the import preferences. Silhouette adds the knife's offset and overcut. Nothing is in the file that may not be cut. Studio draws registration marks itself, print them from there; or set page A4, inset 10.01 mm, length 8.38 mm and thickness 0.99 mm there (0.394, 0.33 and 0.039 in) and lay the file's marks on them, not to be cut: a print has the same. Nothing is cut outside them.</source>
        <translation>無料版が開くのは SVG でなく DXF です。読み込みの設定で大きさは "as is" を選んでください。刃のオフセットとオーバーカットは Silhouette が加えます。切ってはいけないものはファイルに入っていません。位置合わせの印は Studio が自分で描くので、そこから印刷してください。または Studio で用紙 A4、余白 10.01 mm、長さ 8.38 mm、太さ 0.99 mm（0.394、0.33、0.039 インチ）にし、ファイルの印をそこに重ねて、切らない設定にしてください。印刷にも同じ印があります。印の外は切りません。</translation>
    </message>
    <message>
        <source>The goal has {0} combinations to choose from, of which each is tried: list 1 to {1}.</source>
        <translation>目標には {0} 通りの組み合わせがあり、すべて試します。1 から {1} 通りにしてください。</translation>
    </message>
    <message>
        <source>The goal is no JSON object: write {0}.</source>
        <translation>目標が JSON オブジェクトではありません。{0} のように書いてください。</translation>
    </message>
    <message>
        <source>The grain's angle {0} is no number: give degrees from the x axis.</source>
        <translation>流れ方向の角度 {0} は数ではありません。x 軸からの度数で指定してください。</translation>
    </message>
    <message>
        <source>The gussets are deeper than the pouch is high. Choose a smaller depth.</source>
        <translation>マチが袋の高さより深くなっています。小さくしてください。</translation>
    </message>
    <message>
        <source>The hand beside the shape is as large as a grown-up's</source>
        <translation>形の横の手は大人の手の大きさです</translation>
    </message>
    <message>
        <source>The hole at {0} is too small for a {1} seal, and its weld reaches {2} into the balloon: make the hole at least {3} wide, or the seal narrower.</source>
        <translation>{0} の穴は {1} の溶着には小さすぎ、溶着が風船の中へ {2} 入り込みます。穴を幅 {3} 以上にするか、溶着を細くしてください。</translation>
    </message>
    <message>
        <source>The hole at {0} is welded but not cut out: for that, make it wider than two seals with their allowances, {1}.</source>
        <translation>{0} の穴は溶着しますが切り抜きません。切り抜くには、余白込みの溶着 2 本分（{1}）より広くしてください。</translation>
    </message>
    <message>
        <source>The hole at {0} lies in another hole; remove one of them.</source>
        <translation>{0} の穴は別の穴の中にあります。どちらかを消してください。</translation>
    </message>
    <message>
        <source>The hole at {0} lies outside the outline; move it inside.</source>
        <translation>{0} の穴は輪郭の外にあります。内側へ移してください。</translation>
    </message>
    <message>
        <source>The holes of a filled shape stay, the lines of a pen drawing are filled inside</source>
        <translation>塗った形なら穴を残し、線画なら線の内側を塗ります</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: film cannot follow this shape everywhere. Round off notches and widen thin parts.</source>
        <translation>ふくらんだ輪郭は図から平均 {0} 離れます。フィルムはこの形のすべてには追従できません。切れ込みを丸め、細い部分を広げてください。</translation>
    </message>
    <message>
        <source>The inflated outline stays {0} from the drawing on average: the balloon folds across a hole or a spot.</source>
        <translation>ふくらんだ輪郭は図から平均 {0} 離れます。風船が穴か溶着した点を横切って折れています。</translation>
    </message>
    <message>
        <source>The intake cannot lead into a hole of panel {0}: say another edge for the opening.</source>
        <translation>注入口をパネル {0} の穴に向けることはできません。開口を別の辺にしてください。</translation>
    </message>
    <message>
        <source>The intake file {0} calls itself "{1}": give both the same name.</source>
        <translation>注入口のファイル {0} の中の名前は「{1}」です。同じ名前にしてください。</translation>
    </message>
    <message>
        <source>The intake file {0} is of no use: {1}</source>
        <translation>注入口のファイル {0} が使えません：{1}</translation>
    </message>
    <message>
        <source>The intake file {0} lacks {1}: add it.</source>
        <translation>注入口のファイル {0} に {1} がありません。加えてください。</translation>
    </message>
    <message>
        <source>The intake is at the farthest point, on a part that becomes {measured} as thick as the balloon: there it is tied, hangs and is held. A low place carries it better.</source>
        <translation>注入口が最も遠い所にあり、その部分の厚みは風船の {measured} です。風船はそこで結ばれ、つるされ、持たれます。低い所の方がしっかり支えられます。</translation>
    </message>
    <message>
        <source>The intake opens into a part with {percent} of the film; the rest fills through something narrower than the intake. Move it to the largest part.</source>
        <translation>注入口が開く部分はフィルムの {percent} しかなく、残りは注入口より狭い所を通ってふくらみます。最も大きな部分へ移してください。</translation>
    </message>
    <message>
        <source>The intake was left out of the comparison.</source>
        <translation>注入口は比較から省きました。</translation>
    </message>
    <message>
        <source>The intake would run into another part of the balloon: choose another angle or length for it.</source>
        <translation>注入口が風船の別の部分にぶつかります。角度か長さを変えてください。</translation>
    </message>
    <message>
        <source>The intake's angle must be a number.</source>
        <translation>注入口の角度は数で指定してください。</translation>
    </message>
    <message>
        <source>The intake's direction is of two equal panels: of many, say a seam and how far along it.</source>
        <translation>注入口の向きは同じ 2 枚のパネルだけのものです。複数パネルでは継ぎ目とその上の位置を指定してください。</translation>
    </message>
    <message>
        <source>The intake's length must be above 0, up to 100 m: give it about 30 mm.</source>
        <translation>注入口の長さは 0 より大きく 100 m までです。30 mm ほどにしてください。</translation>
    </message>
    <message>
        <source>The intake's place along the seam must be a length.</source>
        <translation>注入口の位置は溶着線に沿った長さで指定してください。</translation>
    </message>
    <message>
        <source>The intake's place cannot be "{0}": choose {1}.</source>
        <translation>注入口の位置「{0}」は使えません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>The intake's width must be between 0.01 mm and 10 m: give it about 10 mm.</source>
        <translation>注入口の幅は 0.01 mm～10 m です。10 mm ほどにしてください。</translation>
    </message>
    <message>
        <source>The intakes of two chambers run into each other: leave a gap in the weld between them, or choose another place for the first.</source>
        <translation>二つの部屋の注入口がぶつかります。間の溶着線にすき間を残すか、最初の注入口を移してください。</translation>
    </message>
    <message>
        <source>The label "{0}" is {1} long, and the film is only {2} wide: take a shorter text or lower letters.</source>
        <translation>文字「{0}」の長さは {1} ですが、フィルムの幅は {2} しかありません。短くするか文字を小さくしてください。</translation>
    </message>
    <message>
        <source>The last {length} of this tip stay flat. A radius of {wanted} makes it rounder.</source>
        <translation>この先端の端は {length} にわたって平らなままです。半径を {wanted} にするともっとふくらみます。</translation>
    </message>
    <message>
        <source>The layer MARK of the machine file {0}.json takes notches only. Rename it NOTCH, and where your machine can draw, add the layers FOLD and PEN.</source>
        <translation>機械のファイル {0}.json のレイヤー MARK には合印しか入りません。名前を NOTCH に変え、機械で描けるならレイヤー FOLD と PEN を加えてください。</translation>
    </message>
    <message>
        <source>The layout failed: give the pieces more room.</source>
        <translation>並べられませんでした。場所を広げてください。</translation>
    </message>
    <message>
        <source>The layout of {0} is older than its patterns: recompute it.</source>
        <translation>{0} の配置は型紙より古くなっています。再計算してください。</translation>
    </message>
    <message>
        <source>The layout on film</source>
        <translation>フィルムへの配置</translation>
    </message>
    <message>
        <source>The layout was stopped; nothing was changed.</source>
        <translation>配置を中止しました。何も変わっていません。</translation>
    </message>
    <message>
        <source>The line at {0} divides no panel.</source>
        <translation>{0} の線はどのパネルも分けません。</translation>
    </message>
    <message>
        <source>The line at {0} misses the body.</source>
        <translation>{0} の線が立体に当たりません。</translation>
    </message>
    <message>
        <source>The lines make up for a kerf of {0} already: leave LightBurn's kerf offset at 0.</source>
        <translation>線はすでに切り幅 {0} を補正してあります。LightBurn のカーフオフセットは 0 のままにしてください。</translation>
    </message>
    <message>
        <source>The lines of the drawing do not close around anything: the outline follows the lines.</source>
        <translation>図の線は何も囲んでいないので、輪郭は線をなぞります。</translation>
    </message>
    <message>
        <source>The machine file {0} calls itself "{1}": give both the same name.</source>
        <translation>機械のファイル {0} の中の名前は「{1}」です。同じ名前にしてください。</translation>
    </message>
    <message>
        <source>The machine file {0} is of no use: {1}</source>
        <translation>機械のファイル {0} が使えません：{1}</translation>
    </message>
    <message>
        <source>The machine file {0} lacks {1}: add it.</source>
        <translation>機械のファイル {0} に {1} がありません。加えてください。</translation>
    </message>
    <message>
        <source>The machine that finds the print again by its registration marks, printed round it</source>
        <translation>まわりに印刷した位置合わせの印で、印刷を見つける機械</translation>
    </message>
    <message>
        <source>The marks round the print span {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>印刷を囲むマークは {0} ですが、{1} で扱えるのは {2} までです。風船を小さくするか、別の機械で印刷して切ってください。</translation>
    </message>
    <message>
        <source>The mesh has a triangle with a point that is not there. Save it once more.</source>
        <translation>メッシュに、存在しない点をもつ三角形があります。保存し直してください。</translation>
    </message>
    <message>
        <source>The mesh has a vertex without triangles. Mesh the outline anew.</source>
        <translation>メッシュに三角形のない節点があります。輪郭のメッシュを作り直してください。</translation>
    </message>
    <message>
        <source>The mesh has no triangle. Save the body as a mesh of triangles.</source>
        <translation>メッシュに三角形がありません。立体を三角形のメッシュとして保存してください。</translation>
    </message>
    <message>
        <source>The mesh has too many triangles, more than {0}. Simplify it in the program that it comes from.</source>
        <translation>メッシュの三角形が多すぎます（{0} 個を超えています）。元のプログラムで簡単にしてください。</translation>
    </message>
    <message>
        <source>The mesh is flat. Give a closed body, or a drawing for two equal panels.</source>
        <translation>メッシュが平らです。閉じた立体か、同じ 2 枚のパネル用の図を渡してください。</translation>
    </message>
    <message>
        <source>The mesh is not closed: a hole is {0} % of its size long round. Close it in the program that the mesh comes from.</source>
        <translation>メッシュが閉じていません。穴の周りの長さが大きさの {0} % あります。メッシュの元のプログラムで閉じてください。</translation>
    </message>
    <message>
        <source>The mesh size is {0}: give one above 0.</source>
        <translation>メッシュの大きさが {0} です。0 より大きくしてください。</translation>
    </message>
    <message>
        <source>The mesh was made simpler. Its triangles were: {0}.</source>
        <translation>メッシュを単純にしました。元の三角形の数: {0}。</translation>
    </message>
    <message>
        <source>The moving picture was stopped.</source>
        <translation>動画の書き出しを止めました。</translation>
    </message>
    <message>
        <source>The native solver cannot be saved. {0}</source>
        <translation>ネイティブソルバーを保存できません。{0}</translation>
    </message>
    <message>
        <source>The native solver could not be fetched from {0} ({1}). Try again when the network is there. {2}</source>
        <translation>ネイティブソルバーを {0} から取得できませんでした（{1}）。ネットワークにつながるときにもう一度試してください。{2}</translation>
    </message>
    <message>
        <source>The native solver is here already.</source>
        <translation>ネイティブソルバーはすでにあります。</translation>
    </message>
    <message>
        <source>The native solver is in use now.</source>
        <translation>これからはネイティブソルバーを使います。</translation>
    </message>
    <message>
        <source>The native solver is not available: {0} Use the NumPy solver.</source>
        <translation>ネイティブソルバーは使えません：{0} NumPy のソルバーを使ってください。</translation>
    </message>
    <message>
        <source>The native solver is not installed. Everything works without it, but simulations take 20 to 30 times longer. Fetch it now?</source>
        <translation>ネイティブソルバーが入っていません。なくてもすべて動きますが、シミュレーションに 20～30 倍の時間がかかります。今すぐ取得しますか？</translation>
    </message>
    <message>
        <source>The native solver was fetched, but does not run here: {0}</source>
        <translation>ネイティブソルバーを取得しましたが、この環境では動きません：{0}</translation>
    </message>
    <message>
        <source>The native solver was not fetched: stopped.</source>
        <translation>ネイティブソルバーの取得を停止しました。</translation>
    </message>
    <message>
        <source>The native solver, which is faster, is not available: {0}</source>
        <translation>高速なネイティブソルバーは使えません：{0}</translation>
    </message>
    <message>
        <source>The nozzle's flange must be wider than its bore.</source>
        <translation>ノズルのフランジは穴より広くしてください。</translation>
    </message>
    <message>
        <source>The number that the controller takes for full power: $30 of GRBL</source>
        <translation>コントローラーが最大出力とみなす数（GRBL の $30）</translation>
    </message>
    <message>
        <source>The opening is at point {0} of panel '{1}', whose points are 0 to {2}. Choose one of them.</source>
        <translation>開口がパネル「{1}」の点 {0} にありますが、点の番号は 0～{2} です。その中から選んでください。</translation>
    </message>
    <message>
        <source>The opening is on a panel '{0}' that is not there. {1}</source>
        <translation>開口が、存在しないパネル「{0}」にあります。{1}</translation>
    </message>
    <message>
        <source>The opening is on panel {0}, but there are {1}. Choose one of them.</source>
        <translation>開口がパネル {0} にありますが、パネルは {1} 枚です。その中から選んでください。</translation>
    </message>
    <message>
        <source>The options cannot be used ({0}). See --help.</source>
        <translation>オプションが使えません（{0}）。--help を見てください。</translation>
    </message>
    <message>
        <source>The outline cannot be mirrored about its axis: draw it symmetric, or leave that.</source>
        <translation>輪郭を軸で反転できません。対称に描くか、そのままにしてください。</translation>
    </message>
    <message>
        <source>The outline comes to its axis more than once. {0}</source>
        <translation>輪郭が軸に 2 回以上来ています。{0}</translation>
    </message>
    <message>
        <source>The outline crosses or nearly touches itself near {0}: separate the parts that meet there.</source>
        <translation>{0} 付近で輪郭が交わるか、ほとんど触れています。離してください。</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be meshed: separate the parts that meet.</source>
        <translation>輪郭が交わるか触れているので、メッシュを作れません。離してください。</translation>
    </message>
    <message>
        <source>The outline crosses or touches itself and cannot be mirrored; part the lines.</source>
        <translation>輪郭が交わるか触れているので、反転できません。線を離してください。</translation>
    </message>
    <message>
        <source>The outline does not pass there any more: delete the edit.</source>
        <translation>輪郭はもうそこを通りません。この編集を消してください。</translation>
    </message>
    <message>
        <source>The outline encloses no area; draw a closed shape with at least three corners.</source>
        <translation>輪郭が面を囲んでいません。角が三つ以上の閉じた形を描いてください。</translation>
    </message>
    <message>
        <source>The outline has a coordinate that is not a number; correct it in the drawing.</source>
        <translation>輪郭に数ではない座標があります。図を直してください。</translation>
    </message>
    <message>
        <source>The outline has no straight upright side on its left, so its axis is missing. {0}</source>
        <translation>輪郭の左にまっすぐ縦の辺がなく、軸がわかりません。{0}</translation>
    </message>
    <message>
        <source>The outline runs another way there: delete the edit.</source>
        <translation>そこでの輪郭の通り方が変わりました。この編集を消してください。</translation>
    </message>
    <message>
        <source>The outline's {0} of {1} cannot be made; bring it to a size between 1 mm and 100 m.</source>
        <translation>輪郭の{0} {1} は作れません。1 mm～100 m の大きさにしてください。</translation>
    </message>
    <message>
        <source>The page will be in English, as no font here has the letters of your language: install IPAexGothic or Noto Sans CJK JP, and open this panel again.</source>
        <translation>日本語のフォントが見つからないため、ページは英語になります。IPAexGothic か Noto Sans CJK JP をインストールして、このパネルを開き直してください。</translation>
    </message>
    <message>
        <source>The painting cannot be written to '{}': is the disk full?</source>
        <translation>絵を「{}」に書き込めません。ディスクがいっぱいではありませんか？</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies. Inflate each by itself.</source>
        <translation>パネルは{0}個の立体に接合されています。それぞれ別にふくらませてください。</translation>
    </message>
    <message>
        <source>The panels are sealed to {0} bodies: panel '{1}' does not hang together with panel '{2}'. Make a bag of each body.</source>
        <translation>パネルが {0} 個の立体に分かれています。パネル「{1}」がパネル「{2}」とつながっていません。立体ごとに袋を作ってください。</translation>
    </message>
    <message>
        <source>The panels have no names. {0}</source>
        <translation>パネルに名前がありません。{0}</translation>
    </message>
    <message>
        <source>The panels have other points than those that were meshed. Mesh the bag anew.</source>
        <translation>パネルの点がメッシュを作ったときと違います。袋のメッシュを作り直してください。</translation>
    </message>
    <message>
        <source>The panels have {0} points, more than {1}. Simplify them in the program that they come from.</source>
        <translation>パネルの点が {0} 個で、{1} 個を超えています。元のプログラムで簡単にしてください。</translation>
    </message>
    <message>
        <source>The part round {0} has no rim for an intake: leave a gap in the welds round it.</source>
        <translation>{0} のまわりの部分には注入口を付ける縁がありません。まわりの溶着線にすき間を残してください。</translation>
    </message>
    <message>
        <source>The pattern becomes too thin for its mesh. Widen the thin parts, or use a finer mesh.</source>
        <translation>型紙がメッシュに対して細くなりすぎます。細い部分を広げるか、メッシュを細かくしてください。</translation>
    </message>
    <message>
        <source>The pattern crosses itself near {0}: simplify the drawing there.</source>
        <translation>{0} 付近で型紙が交わります。そこの図を簡単にしてください。</translation>
    </message>
    <message>
        <source>The pattern has no lines for {0}, which takes {1}: choose another machine.</source>
        <translation>型紙に {0} 用の線がありません（必要：{1}）。別の機械を選んでください。</translation>
    </message>
    <message>
        <source>The pattern is being fitted to the painting ...</source>
        <translation>型紙を絵に合わせています…</translation>
    </message>
    <message>
        <source>The pattern measures {0}, the bed of {1} is {2}</source>
        <translation>型紙は {0}、{1} の加工台は {2} です</translation>
    </message>
    <message>
        <source>The photograph shows the back: it was mirrored.</source>
        <translation>写真に写っているのは裏です。反転しました。</translation>
    </message>
    <message>
        <source>The photograph shows too many shapes: take one of the balloon alone, on a plain background.</source>
        <translation>写真に形が多すぎます。無地の背景で、風船だけを撮ってください。</translation>
    </message>
    <message>
        <source>The picture has a single colour. Choose one that shows a shape on a background.</source>
        <translation>画像が一色だけです。背景の上に形が見えるものを選んでください。</translation>
    </message>
    <message>
        <source>The picture has no plain background around the shape. Use one with a background of one colour or a transparent one.</source>
        <translation>形のまわりが無地ではありません。背景が一色か透明の画像を使ってください。</translation>
    </message>
    <message>
        <source>The picture is empty: all of it is transparent. Choose a picture that shows a shape.</source>
        <translation>画像が空（全体が透明）です。形のある画像を選んでください。</translation>
    </message>
    <message>
        <source>The picture is too small to see a shape. Use {0} pixels or more across.</source>
        <translation>画像が小さすぎて形が分かりません。{0} ピクセル以上にしてください。</translation>
    </message>
    <message>
        <source>The picture is traced as it is without a choice of yours</source>
        <translation>指定がないときと同じように画像をなぞります</translation>
    </message>
    <message>
        <source>The picture of a body of gores goes all round: leave out --artwork-back.</source>
        <translation>ゴアの立体の絵は全周に回ります。--artwork-back を外してください。</translation>
    </message>
    <message>
        <source>The picture was read as a pen drawing: the inside of its lines is filled.</source>
        <translation>線画として読み込み、線の内側を塗りました。</translation>
    </message>
    <message>
        <source>The picture, and all figures as JSON</source>
        <translation>画像と、すべての数値の JSON</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are cut from {1}: they have a file of their own, with all of them for each balloon.</source>
        <translation>注入口「{0}」の部品は {1} から切ります。風船ごとの全部品を入れた別のファイルがあります。</translation>
    </message>
    <message>
        <source>The pieces of the intake "{0}" are of {1}, which does not weld to {2}: choose another intake, or a film that it welds to: {3}.</source>
        <translation>注入口「{0}」の部品は {1} で、{2} とは溶着しません。別の注入口か、それと溶着できるフィルムを選んでください：{3}。</translation>
    </message>
    <message>
        <source>The place {0} is not on panels {1}, between which the seam lies.</source>
        <translation>位置 {0} は、継ぎ目の両側のパネル {1} の上にありません。</translation>
    </message>
    <message>
        <source>The plane through {0} divides no panel.</source>
        <translation>{0} を通る平面はどのパネルも分けません。</translation>
    </message>
    <message>
        <source>The plane through {0} does not meet the body.</source>
        <translation>{0} を通る平面は立体と交わりません。</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set mark type 1 and a size of 10 mm there. The layer REGISTRATION is not cut. The knife's offset belongs into the plotter.</source>
        <translation>プロッターが印刷の印を自分で見つけます。プロッターでマークの種類を 1、大きさを 10 mm にしてください。レイヤー REGISTRATION は切りません。刃のオフセットはプロッターに設定します。</translation>
    </message>
    <message>
        <source>The plotter finds the marks of a print itself. Set shape 1 and a size of 10 mm there. FineCut takes marks only that it made itself: let it make them in the place of these. The layer REGISTRATION is not cut.</source>
        <translation>プロッターが印刷の印を自分で見つけます。プロッターで形を 1、大きさを 10 mm にしてください。FineCut は自分で作った印しか使わないので、同じ場所に FineCut で印を作ってください。レイヤー REGISTRATION は切りません。</translation>
    </message>
    <message>
        <source>The pressure at the lower end must be 0 or more.</source>
        <translation>下端の圧力は 0 以上でなければなりません。</translation>
    </message>
    <message>
        <source>The pressure must be positive and at most {0}, not {1}. A party balloon has about 2 kPa.</source>
        <translation>圧力は 0 より大きく {0} 以下にしてください（指定は {1}）。パーティー用の風船は約 2 kPa です。</translation>
    </message>
    <message>
        <source>The pressure must grow upwards: give a gradient of 0 or more.</source>
        <translation>圧力は上に向かって大きくならなければなりません。0 以上の勾配にしてください。</translation>
    </message>
    <message>
        <source>The preview picture needs matplotlib: install it with pip install matplotlib.</source>
        <translation>プレビュー画像には matplotlib が必要です。pip install matplotlib で入れてください。</translation>
    </message>
    <message>
        <source>The print has {0}, and {1} looks for others: print once more with its marks ({2}).</source>
        <translation>印刷にあるのは{0}ですが、{1} は別の印を探します。その印（{2}）でもう一度印刷してください。</translation>
    </message>
    <message>
        <source>The print measures {0}, and between the marks of {1} there are {2} on paper of {3}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>印刷の大きさは {0} ですが、{3} の用紙では {1} の印の間が {2} です。風船を小さくするか、自分の機械のファイルの印の page_mm でもっと大きい用紙を指定してください。</translation>
    </message>
    <message>
        <source>The print measures {0}, and {1} takes at most {2}: make the balloon smaller, or print and cut it on another machine.</source>
        <translation>印刷は {0} ですが、{1} で扱えるのは {2} までです。風船を小さくするか、別の機械で印刷して切ってください。</translation>
    </message>
    <message>
        <source>The print on film</source>
        <translation>フィルムへの印刷</translation>
    </message>
    <message>
        <source>The print reaches into the marks of {0}, or comes nearer than {1}: make the balloon smaller, or give larger paper as page_mm of the marks in a file of your machine.</source>
        <translation>印刷が {0} の印にかかるか、{1} より近づきます。風船を小さくするか、自分の機械のファイルの印の page_mm でもっと大きい用紙を指定してください。</translation>
    </message>
    <message>
        <source>The profile crosses or touches itself at {0}. Draw a simple line.</source>
        <translation>断面が {0} で自分と交わるか接しています。単純な線を描いてください。</translation>
    </message>
    <message>
        <source>The profile goes to the other side of its axis at the height {0}: the radius is {1}. Draw one half only.</source>
        <translation>断面が高さ {0} で軸の反対側に出ています（半径 {1}）。片側だけを描いてください。</translation>
    </message>
    <message>
        <source>The profile has more than {0} points. Simplify it.</source>
        <translation>断面の点が {0} 個を超えています。簡単にしてください。</translation>
    </message>
    <message>
        <source>The profile is a closed line that does not run along its axis. Draw one half of the section, from the lower to the upper end.</source>
        <translation>断面が軸に沿わない閉じた線です。下端から上端まで、断面の半分を描いてください。</translation>
    </message>
    <message>
        <source>The profile is too slender for a disc of {0} at its {1} end. Let the gores meet in a point there.</source>
        <translation>断面が細すぎて、端（{1}）に {0} の円板が付きません。そこではゴアを 1 点に集めてください。</translation>
    </message>
    <message>
        <source>The profile is {0} large. Give it a size between {1} and {2}, and check its unit.</source>
        <translation>断面の大きさが {0} です。{1}～{2} にして、単位を確かめてください。</translation>
    </message>
    <message>
        <source>The profile lies on its axis. Draw the half outline at a distance from it.</source>
        <translation>断面が軸の上にあります。輪郭の半分を軸から離して描いてください。</translation>
    </message>
    <message>
        <source>The profile needs at least two points, each a pair of numbers: radius and height.</source>
        <translation>断面には 2 点以上が必要です。各点は半径と高さの 2 つの数です。</translation>
    </message>
    <message>
        <source>The profile touches its axis at the height {0}, which parts the balloon in two. Keep it away from the axis there.</source>
        <translation>断面が高さ {0} で軸に接し、風船が 2 つに分かれます。そこを軸から離してください。</translation>
    </message>
    <message>
        <source>The radius of the corner relief must be 0 or above.</source>
        <translation>角の逃げの半径は 0 以上にしてください。</translation>
    </message>
    <message>
        <source>The remnant is of {0} film, and no piece here is cut from that.</source>
        <translation>残材は {0} のフィルムですが、ここにはそれから切る部品がありません。</translation>
    </message>
    <message>
        <source>The remnant {0} is of no use: {1}</source>
        <translation>残材 {0} が使えません：{1}</translation>
    </message>
    <message>
        <source>The remnant {0} lacks {1}: add it.</source>
        <translation>残材 {0} に {1} がありません。加えてください。</translation>
    </message>
    <message>
        <source>The repair at {0} no longer fits, {1}: take it back or draw that part anew.</source>
        <translation>{0} の修正は合わなくなりました（{1}）。取り消すか、その部分を描き直してください。</translation>
    </message>
    <message>
        <source>The rest of the job</source>
        <translation>そのほかのファイル</translation>
    </message>
    <message>
        <source>The rim is the width of the weld and of the film beside it: give 0 to 1 m.</source>
        <translation>縁は溶着線とその外側のフィルムを合わせた幅です。0～1 m にしてください。</translation>
    </message>
    <message>
        <source>The row has more cells than there are columns: leave out what is too much.</source>
        <translation>行のセルが列より多くあります。余分なセルを外してください。</translation>
    </message>
    <message>
        <source>The row has no input: give it the name of a drawing.</source>
        <translation>行に input がありません。図の名前を指定してください。</translation>
    </message>
    <message>
        <source>The same in all rows</source>
        <translation>すべての行に共通</translation>
    </message>
    <message>
        <source>The same length as it is, such as 300 mm</source>
        <translation>同じ部分の実際の長さ（300 mm など）</translation>
    </message>
    <message>
        <source>The scale '{0}' cannot be used: {1}.</source>
        <translation>縮尺「{0}」は使えません：{1}。</translation>
    </message>
    <message>
        <source>The scale of {0} over {1} pixels has no length: mark two points that are far apart, and give the distance between them.</source>
        <translation>{1} ピクセルで {0} という縮尺には長さがありません。遠く離れた 2 点に印を付け、その間の距離を指定してください。</translation>
    </message>
    <message>
        <source>The scheduler of Dask went away: start it and the study again; nothing is lost.</source>
        <translation>Dask のスケジューラーがなくなりました。スケジューラーとスタディをもう一度始めてください。何も失われません。</translation>
    </message>
    <message>
        <source>The seal width must be between 0.01 mm and 1 m, the allowance between 0 and 1 m.</source>
        <translation>溶着幅は 0.01 mm～1 m、余白は 0～1 m にしてください。</translation>
    </message>
    <message>
        <source>The seam near {0} divides no panel.</source>
        <translation>{0} 付近の継ぎ目はどのパネルも分けません。</translation>
    </message>
    <message>
        <source>The seam near {0} is one of {1}, not of {2}.</source>
        <translation>{0} 付近の継ぎ目は {2} ではなく {1} のものです。</translation>
    </message>
    <message>
        <source>The seam near {0} would divide panels {1}, not {2}.</source>
        <translation>{0} 付近の継ぎ目は、パネル {2} ではなく {1} を分けることになります。</translation>
    </message>
    <message>
        <source>The seams of {0} gores stand out by up to {1} over their middles. More gores make the body rounder.</source>
        <translation>ゴア {0} 枚の継ぎ目は中央より最大 {1} 外に出ます。ゴアを増やすと丸くなります。</translation>
    </message>
    <message>
        <source>The search for a goal asks for a few balloons at a time, of this machine: leave out --scheduler and --dask.</source>
        <translation>目標の探索では、このマシンで一度に少しずつ風船を作ります。--scheduler と --dask を外してください。</translation>
    </message>
    <message>
        <source>The search for a goal finds its balloons one after the other: leave out --shard, --script, --dry-run and --collect; what is there already is not made again.</source>
        <translation>目標の探索では風船を順に見つけます。--shard、--script、--dry-run、--collect を外してください。すでにあるものは作り直しません。</translation>
    </message>
    <message>
        <source>The search for a goal needs scipy: install it with pip install scipy.</source>
        <translation>目標の探索には scipy が必要です。pip install scipy で入れてください。</translation>
    </message>
    <message>
        <source>The search was stopped; what was made stays.</source>
        <translation>探索を中止しました。作ったものは残ります。</translation>
    </message>
    <message>
        <source>The search with optuna needs its package: install it with pip install optuna, or leave out "search".</source>
        <translation>optuna での探索にはそのパッケージが必要です。pip install optuna で入れるか、"search" を外してください。</translation>
    </message>
    <message>
        <source>The seed is a whole number from 0 up, not {0}.</source>
        <translation>シードは {0} ではなく、0 以上の整数です。</translation>
    </message>
    <message>
        <source>The selected sketches, wires and flat faces become the panels</source>
        <translation>選んだスケッチ、ワイヤー、平らな面がパネルになります</translation>
    </message>
    <message>
        <source>The settings lack "{0}": write {"{1}": {2}} into their file.</source>
        <translation>設定に「{0}」がありません。設定ファイルに {"{1}": {2}} と書いてください。</translation>
    </message>
    <message>
        <source>The shape has the colour of a shadow: shadows on the background count as part of it.</source>
        <translation>形の色が影の色と同じです。背景の影も形の一部として数えます。</translation>
    </message>
    <message>
        <source>The shape in the photograph measures {0}, {1} were expected: check the scale, or whether it is the right photograph.</source>
        <translation>写真の形の大きさは {0} ですが、予想は {1} です。縮尺と、正しい写真かどうかを確かめてください。</translation>
    </message>
    <message>
        <source>The shape in the picture is too frayed to trace. Use a clearer picture.</source>
        <translation>画像の形の縁が荒れすぎてなぞれません。もっとはっきりした画像を使ってください。</translation>
    </message>
    <message>
        <source>The shape is only {0} thick near {1}, too thin for a mesh of {2}: make it thicker there, or use a mesh size of at most {3}.</source>
        <translation>{1} 付近の太さは {0} しかなく、{2} のメッシュには細すぎます。太くするか、メッシュを {3} 以下にしてください。</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the photograph: take one that shows all of it on a plain background.</source>
        <translation>形が写真の{0}端に触れています。無地の背景で、形全体が写るように撮ってください。</translation>
    </message>
    <message>
        <source>The shape touches the {0} border of the picture; if it was cut off there, leave more margin.</source>
        <translation>形が画像の{0}端に触れています。切れているなら余白を増やしてください。</translation>
    </message>
    <message>
        <source>The side band has no width: give its width, or the thickness of the balloon.</source>
        <translation>側面の帯に幅がありません。幅か風船の厚さを指定してください。</translation>
    </message>
    <message>
        <source>The side band is too wide for this drawing, whose parts are about {0} wide: give it at most {1}.</source>
        <translation>図の部分の幅は約 {0} で、側面の帯が広すぎます。{1} 以下にしてください。</translation>
    </message>
    <message>
        <source>The side band must be wider than 0, not {0}. Give it 20 mm or so.</source>
        <translation>側面の帯の幅は 0 より大きくなければなりません（今は {0}）。20 mm ほどにしてください。</translation>
    </message>
    <message>
        <source>The side band of {0} leaves nothing of the front, whose widest part is {1} wide: give it at most {2}.</source>
        <translation>側面の帯 {0} では、最も広い部分が {1} の表が残りません。{2} 以下にしてください。</translation>
    </message>
    <message>
        <source>The sides of seam {0} are not equally long: {1}, {2}. Make them equally long, or allow them ease.</source>
        <translation>継ぎ目 {0} の両側の長さが違います：{1}、{2}。同じ長さにするか、ゆとりを認めてください。</translation>
    </message>
    <message>
        <source>The sides of seam {0} are {1} and {2} long. Make them equally long.</source>
        <translation>継ぎ目{0}の両側の長さは{1}と{2}です。同じ長さにしてください。</translation>
    </message>
    <message>
        <source>The simulation cannot take its first step. Check the outline for degenerate parts.</source>
        <translation>シミュレーションの最初のステップを計算できません。輪郭につぶれた部分がないか確かめてください。</translation>
    </message>
    <message>
        <source>The simulation did not come to rest; the shape shown is its last good state. Try a coarser mesh.</source>
        <translation>シミュレーションが収束しませんでした。表示は最後の良い状態です。メッシュを粗くしてみてください。</translation>
    </message>
    <message>
        <source>The simulation failed: {0}. Check the outline for degenerate parts.</source>
        <translation>シミュレーションに失敗しました：{0}。輪郭につぶれた部分がないか確かめてください。</translation>
    </message>
    <message>
        <source>The simulation has no finite start. Check the outline for degenerate parts.</source>
        <translation>シミュレーションの初期状態が有限ではありません。輪郭につぶれた部分がないか確かめてください。</translation>
    </message>
    <message>
        <source>The simulation was stopped.</source>
        <translation>シミュレーションを停止しました。</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there, or of more and narrower panels.</source>
        <translation>大きさは {0} で決まっています。そちらで小さくするか、細いパネルを増やしてください。</translation>
    </message>
    <message>
        <source>The size comes from {0}: make it smaller there.</source>
        <translation>大きさは {0} で決まります。そちらで小さくしてください。</translation>
    </message>
    <message>
        <source>The size follows from a volume or a lift: choose a smaller one.</source>
        <translation>大きさは体積か浮力で決まります。その値を小さくしてください。</translation>
    </message>
    <message>
        <source>The size of {0} is set by an expression: change the value that it uses.</source>
        <translation>{0} の大きさは式で決まります。式が参照する値を変えてください。</translation>
    </message>
    <message>
        <source>The slant of a cone is longer than its radius. Choose a longer slant.</source>
        <translation>円錐の母線は半径より長くなければなりません。長くしてください。</translation>
    </message>
    <message>
        <source>The smallest radius is {0}, near {1}; {2} follows {3}. It will come out rounder there.</source>
        <translation>最小の半径は {1} 付近の {0} で、{2} が追えるのは {3} までです。そこは丸くなります。</translation>
    </message>
    <message>
        <source>The solver '{0}' needs the Python package scipy. Install it or use the native solver.</source>
        <translation>ソルバー「{0}」には Python パッケージ scipy が必要です。入れるか、ネイティブソルバーを使ってください。</translation>
    </message>
    <message>
        <source>The speed of welding must be above 0, and the time for each seam not below it.</source>
        <translation>溶着の速さは 0 より大きく、継ぎ目ごとの時間は 0 以上でなければなりません。</translation>
    </message>
    <message>
        <source>The spread of {0} cannot be {1}: write it with its unit, such as "{2}".</source>
        <translation>{0} のばらつきは {1} にできません。「{2}」のように単位を付けて書いてください。</translation>
    </message>
    <message>
        <source>The spread of {0} has "{1}", which is none of {2}.</source>
        <translation>{0} のばらつきにある「{1}」は {2} のどれでもありません。</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: give one above 0, or leave it out.</source>
        <translation>{0} のばらつきが {1} です。0 より大きくするか、外してください。</translation>
    </message>
    <message>
        <source>The spread of {0} is {1}: write one {2}.</source>
        <translation>{0} のばらつきが {1} です。書き直してください（{2}）。</translation>
    </message>
    <message>
        <source>The step of {0} has another unit than its ends: write the same one.</source>
        <translation>{0} の刻みの単位が両端と違います。同じ単位で書いてください。</translation>
    </message>
    <message>
        <source>The strips of valves are not here: lay them out on a sheet of their own, with "Valve film".</source>
        <translation>弁の帯はここにはありません。「弁のフィルム」を選び、別のシートに並べてください。</translation>
    </message>
    <message>
        <source>The study cannot go on ({0}).</source>
        <translation>スタディを続けられません（{0}）。</translation>
    </message>
    <message>
        <source>The study has no inputs: give it a column 'input' with the names of drawings.</source>
        <translation>スタディに入力がありません。図の名前を並べた列「input」を加えてください。</translation>
    </message>
    <message>
        <source>The study has no rows.</source>
        <translation>スタディに行がありません。</translation>
    </message>
    <message>
        <source>The study has the column {0} twice.</source>
        <translation>スタディに列 {0} が 2 つあります。</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values, or give --most {2} if that is meant.</source>
        <translation>スタディに {0} 行あり、{1} を超えています。値を減らすか、これでよければ --most {2} を指定してください。</translation>
    </message>
    <message>
        <source>The study has {0} rows, more than {1}: take fewer values.</source>
        <translation>スタディに {0} 行あり、{1} を超えています。値を減らしてください。</translation>
    </message>
    <message>
        <source>The study is no JSON object: begin it with {"vary": ...}.</source>
        <translation>スタディが JSON オブジェクトではありません。{"vary": ...} で始めてください。</translation>
    </message>
    <message>
        <source>The study was stopped.</source>
        <translation>スタディを中止しました。</translation>
    </message>
    <message>
        <source>The summary cannot be shown ({0}); {1}.</source>
        <translation>要約を表示できません（{0}）。{1}。</translation>
    </message>
    <message>
        <source>The surface cannot be laid flat: some of its triangles have no area, or a panel hangs together in a point only. Repair the body, or take another number of panels.</source>
        <translation>表面を平らに展開できません。面積のない三角形があるか、パネルが 1 点だけでつながっています。立体を修復するか、パネルの数を変えてください。</translation>
    </message>
    <message>
        <source>The surface crosses itself, at ({0}) of the mesh. Film cannot follow it there. Triangles that cross others: {1}.</source>
        <translation>表面が自分と交わっています（メッシュの ({0})）。そこではフィルムが沿えません。ほかと交わる三角形：{1}。</translation>
    </message>
    <message>
        <source>The surface of the mesh has no outside, as a Moebius strip. Give the mesh of a solid.</source>
        <translation>メッシュの表面に外側がありません（メビウスの帯のような形）。ソリッドのメッシュを渡してください。</translation>
    </message>
    <message>
        <source>The temperature of the {0}, {1} degrees Celsius, is out of range: give one such as 20C.</source>
        <translation>温度（{0}）{1} ℃ は範囲外です。20C のように指定してください。</translation>
    </message>
    <message>
        <source>The test card measures {0}, the bed of {1} is {2}: try fewer values, or say with --bed how large it is.</source>
        <translation>テストカードは {0}、{1} の加工範囲は {2} です: 値を減らすか、--bed で大きさを指定してください。</translation>
    </message>
    <message>
        <source>The thickness of the balloon decides the width of its side band: give one of them.</source>
        <translation>側面の帯の幅は風船の厚さで決まります。どちらか一方を指定してください。</translation>
    </message>
    <message>
        <source>The tie tab at {0} degrees would run into another part: choose another angle.</source>
        <translation>{0} 度の耳は別の部分にぶつかります。角度を変えてください。</translation>
    </message>
    <message>
        <source>The valve reaches {0} into the balloon, past the weld at {1}: put the intake where the balloon is longer, or take another one.</source>
        <translation>弁が風船の中へ {0} 入り、{1} で溶着線を越えます。風船がもっと長い所に注入口を付けるか、別の注入口にしてください。</translation>
    </message>
    <message>
        <source>The vertices along both sides of seam {0} are up to {1} apart. Put them at equal lengths along it.</source>
        <translation>継ぎ目{0}の両側の頂点が最大{1}ずれています。同じ長さの位置に置いてください。</translation>
    </message>
    <message>
        <source>The volume must be positive, not {0}.</source>
        <translation>体積は 0 より大きくしてください（指定は {0}）。</translation>
    </message>
    <message>
        <source>The way from the intake into the balloon narrows to {0}, and the intake is {1} wide: put it where the balloon is wider, else air enters slowly.</source>
        <translation>注入口から風船への通路が {0} に狭まります（注入口の幅は {1}）。もっと広い所に付けないと、空気がゆっくりしか入りません。</translation>
    </message>
    <message>
        <source>The weld draws the seam inward by {0}</source>
        <translation>溶着で継ぎ目が内側へ寄る量：{0}</translation>
    </message>
    <message>
        <source>The width and the height must be more than 0.</source>
        <translation>幅と高さは 0 より大きくなければなりません。</translation>
    </message>
    <message>
        <source>The width of the passages must be 0 or above.</source>
        <translation>通路の幅は 0 以上にしてください。</translation>
    </message>
    <message>
        <source>The worker on {0}</source>
        <translation>{0} のワーカー</translation>
    </message>
    <message>
        <source>The worker on {0} cannot work: {1}</source>
        <translation>{0} のワーカーが動作できません：{1}</translation>
    </message>
    <message>
        <source>The {0} "{1}" of the material card {2} cannot be read: correct the card.</source>
        <translation>材料カード {2} の {0}「{1}」を読めません。カードを直してください。</translation>
    </message>
    <message>
        <source>The {0} bears {1} here with a margin of {2}, and the pressure is {3}. Inflate it to less, or take a stronger film.</source>
        <translation>{0}：ここでは余裕 {2} で {1} に耐え、圧力は {3} です。圧力を下げるか、強いフィルムを使ってください。</translation>
    </message>
    <message>
        <source>The {0} crosses or touches itself at {1}; part the lines there.</source>
        <translation>{1} で線が交わるか触れています（{0}）。離してください。</translation>
    </message>
    <message>
        <source>The {0} encloses no area; draw a closed shape with at least three corners.</source>
        <translation>面を囲んでいません（{0}）。角が三つ以上の閉じた形を描いてください。</translation>
    </message>
    <message>
        <source>The {0} end of the profile is '{1}'. Use one of {2}.</source>
        <translation>断面の端（{0}）が「{1}」です。{2} のどれかにしてください。</translation>
    </message>
    <message>
        <source>The {0} end of the profile is {1} away from the axis, so no gores can meet there in a point. Close it with a disc, or leave it open.</source>
        <translation>断面の端（{0}）は軸から {1} 離れているため、ゴアを 1 点に集められません。円板で閉じるか、開けておいてください。</translation>
    </message>
    <message>
        <source>The {0} file has a point that is no three numbers. Save it once more.</source>
        <translation>{0} ファイルに、3 つの数でない点があります。保存し直してください。</translation>
    </message>
    <message>
        <source>The {0} is {1} mm: give one above 0, for example 300 mm.</source>
        <translation>寸法（{0}）が {1} mm です。300 mm のように 0 より大きくしてください。</translation>
    </message>
    <message>
        <source>The {0} is {1} off its goal: change the goal by as much.</source>
        <translation>目標（{0}）から {1} ずれました。その分だけ目標を直してください。</translation>
    </message>
    <message>
        <source>The {0} is {1}, not between {2} and {3} {4}: give one such as {5}.</source>
        <translation>値（{0}）は {1} で、{2}～{3} {4} の範囲にありません。{5} のように指定してください。</translation>
    </message>
    <message>
        <source>The {0} line crosses itself near {1}: simplify the drawing there.</source>
        <translation>{0} の線が {1} 付近で交わります。そこの図を簡単にしてください。</translation>
    </message>
    <message>
        <source>The {0} line runs back along itself near {1}: simplify the drawing there.</source>
        <translation>{0} の線が {1} 付近で折り返して自分に重なります。そこの図を簡単にしてください。</translation>
    </message>
    <message>
        <source>The {0} line that begins at {1} is open: programs fill, offset and cut closed lines only. Close it.</source>
        <translation>{1} で始まる {0} の線が閉じていません。塗り、オフセット、切断には閉じた線が必要です。閉じてください。</translation>
    </message>
    <message>
        <source>The {0} must be between 0 and {1}.</source>
        <translation>{0} は 0 から {1} の間でなければなりません。</translation>
    </message>
    <message>
        <source>The {0} of a {1} must be from {2} to {3}.</source>
        <translation>工具（{1}）の値（{0}）は {2}～{3} にしてください。</translation>
    </message>
    <message>
        <source>The {0} strays by {1} % in sample {2}, which leaves nothing of it: give a smaller spread.</source>
        <translation>サンプル {2} で{0}が {1} % ずれ、何も残りません。ばらつきを小さくしてください。</translation>
    </message>
    <message>
        <source>Their depth</source>
        <translation>切り込みの深さ</translation>
    </message>
    <message>
        <source>There are no panels: choose sketches or flat faces.</source>
        <translation>パネルがありません。スケッチか平らな面を選んでください。</translation>
    </message>
    <message>
        <source>There are seams in the planes of symmetry already.</source>
        <translation>対称面にはすでに継ぎ目があります。</translation>
    </message>
    <message>
        <source>There can be 0 to {0} notches, not {1}, with a depth above 0.</source>
        <translation>合印は 0～{0} 個（指定は {1}）、深さは 0 より大きくしてください。</translation>
    </message>
    <message>
        <source>There can be 1 to {0} copies, not {1}.</source>
        <translation>枚数は 1～{0} です（指定は {1}）。</translation>
    </message>
    <message>
        <source>There is a machine {0} already: give this one another name.</source>
        <translation>機械 {0} はすでにあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>There is advice about two equal panels only: of many, the warnings tell.</source>
        <translation>助言は同じ 2 枚のパネルだけのものです。複数パネルでは警告が知らせます。</translation>
    </message>
    <message>
        <source>There is no "{0}" to repair in {1}: see its advice.</source>
        <translation>{1} には直すべき「{0}」がありません。助言を確かめてください。</translation>
    </message>
    <message>
        <source>There is no column '{0}': {1}.</source>
        <translation>列「{0}」はありません。{1}。</translation>
    </message>
    <message>
        <source>There is no file '{0}'. Check the name and the folder.</source>
        <translation>ファイル「{0}」がありません。名前とフォルダーを確かめてください。</translation>
    </message>
    <message>
        <source>There is no file {0}, and no such ready body: check the name and the folder.</source>
        <translation>ファイル {0} も、その名前の既製の立体もありません。名前とフォルダーを確かめてください。</translation>
    </message>
    <message>
        <source>There is no file {0}: check the name and the folder.</source>
        <translation>ファイル {0} がありません。名前とフォルダーを確かめてください。</translation>
    </message>
    <message>
        <source>There is no file {}: check the name and the folder.</source>
        <translation>ファイル {} がありません。名前とフォルダーを確かめてください。</translation>
    </message>
    <message>
        <source>There is no film "{0}": choose one of {1}.</source>
        <translation>フィルム「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no gas "{0}": choose one of {1}.</source>
        <translation>気体「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no hole any more: delete the edit.</source>
        <translation>穴がもうありません。この編集を消してください。</translation>
    </message>
    <message>
        <source>There is no hole at {0}: give a place on its edge.</source>
        <translation>{0} に穴はありません。穴の縁の位置を指定してください。</translation>
    </message>
    <message>
        <source>There is no intake "{0}": choose one of {1}.</source>
        <translation>注入口「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no joining "{0}": choose one of {1}.</source>
        <translation>接合方法「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no language "{0}": choose one of {1}.</source>
        <translation>言語「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no look "{0}": choose one of {1}.</source>
        <translation>外観「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no machine "{0}": choose one of {1}, or give a .json file.</source>
        <translation>機械「{0}」はありません。{1} から選ぶか、.json ファイルを指定してください。</translation>
    </message>
    <message>
        <source>There is no native solver for {0}. {1}</source>
        <translation>{0} 用のネイティブソルバーはありません。{1}</translation>
    </message>
    <message>
        <source>There is no native solver to be fetched for this version yet. {0}</source>
        <translation>この版のネイティブソルバーはまだ取得できません。{0}</translation>
    </message>
    <message>
        <source>There is no node near {0}: add one there.</source>
        <translation>{0} の近くにノードがありません。そこに加えてください。</translation>
    </message>
    <message>
        <source>There is no outline at {0} degrees from the centre: choose another intake angle.</source>
        <translation>中心から {0} 度の方向に輪郭がありません。注入口の角度を変えてください。</translation>
    </message>
    <message>
        <source>There is no panel. Give at least one.</source>
        <translation>パネルがありません。少なくとも1枚指定してください。</translation>
    </message>
    <message>
        <source>There is no paper "{0}" for the assembly sheet: choose A4 or Letter.</source>
        <translation>組み立て図に用紙「{0}」は使えません。A4 か Letter を選んでください。</translation>
    </message>
    <message>
        <source>There is no paper "{0}": choose A4, A3 or Letter.</source>
        <translation>「{0}」という用紙はありません。A4、A3、レターから選んでください。</translation>
    </message>
    <message>
        <source>There is no picture to paste: copy one first.</source>
        <translation>貼り付ける画像がありません。先にコピーしてください。</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the balloon has none of its own.</source>
        <translation>印刷する絵がありません。風船に絵がないので、選んでください。</translation>
    </message>
    <message>
        <source>There is no picture to print: choose one, as the outline has none of its own.</source>
        <translation>印刷する画像がありません。輪郭には画像がないので、選んでください。</translation>
    </message>
    <message>
        <source>There is no ready body '{0}'. Choose one of {1}.</source>
        <translation>既製の立体「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is no result '{0}': take {1}.</source>
        <translation>結果「{0}」はありません。{1} を使ってください。</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} in its middle: choose another panel or a smaller one.</source>
        <translation>中央に {0} のフランジを置く場所がありません。別のパネルか小さなものを選んでください。</translation>
    </message>
    <message>
        <source>There is no room for a flange of {0} there: choose another place or a smaller one.</source>
        <translation>そこに {0} のフランジは入りません。別の場所か小さなフランジにしてください。</translation>
    </message>
    <message>
        <source>There is no seam between panels {0}.</source>
        <translation>パネル {0} の間に継ぎ目はありません。</translation>
    </message>
    <message>
        <source>There is no seam near {0}.</source>
        <translation>{0} 付近に継ぎ目はありません。</translation>
    </message>
    <message>
        <source>There is no seam {0} for the opening: the seams are 1 to {1}.</source>
        <translation>開口に使う継ぎ目 {0} はありません。継ぎ目は 1～{1} です。</translation>
    </message>
    <message>
        <source>There is no share {0} of {1}: write one from 1/{2} on.</source>
        <translation>{1} 分割の {0} 番目はありません。1/{2} から始まる分割を書いてください。</translation>
    </message>
    <message>
        <source>There is no sheet {0}: give a number from 1 to {1}.</source>
        <translation>シート {0} はありません。1～{1} の番号にしてください。</translation>
    </message>
    <message>
        <source>There is no solver named '{0}'. Use 'native', 'numpy' or 'newmark'.</source>
        <translation>「{0}」というソルバーはありません。'native'、'numpy'、'newmark' を使ってください。</translation>
    </message>
    <message>
        <source>There is no symmetry "{0}": choose one of {1}.</source>
        <translation>対称「{0}」はありません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>There is nothing to copy: paint something, or select it.</source>
        <translation>コピーするものがありません。何か描くか、選んでください。</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs.</source>
        <translation>メモリーが足りません。メッシュを粗くするか、ほかのプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>There is too little memory for this: take a coarser mesh, or close other programs. Details are in '{0}'.</source>
        <translation>メモリーが足りません。メッシュを粗くするか、ほかのプログラムを閉じてください。詳細は「{0}」にあります。</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚み</translation>
    </message>
    <message>
        <source>Thickness of the balloon</source>
        <translation>風船の厚み</translation>
    </message>
    <message>
        <source>Thickness of the pen ([ thinner, ] thicker)</source>
        <translation>ペンの太さ（[ 細く、] 太く）</translation>
    </message>
    <message>
        <source>This Python has no working ctypes module, which SciPy and the native solver need: patterns can be changed and written, but no balloon can be inflated anew. Take another build of FreeCAD or of Python.</source>
        <translation>この Python では、SciPy とネイティブソルバーに必要な ctypes モジュールが動きません。型紙の変更と書き出しはできますが、風船を新たにふくらませることはできません。別のビルドの FreeCAD か Python を使ってください。</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: drawn {width} wide, it becomes {measured} thick. Make it {wanted} wide.</source>
        <translation>この腕は細すぎてふくらみません。描いた幅は {width}、ふくらむ厚みは {measured} です。幅を {wanted} にしてください。</translation>
    </message>
    <message>
        <source>This arm is too thin to fill: {}. Make it {}?</source>
        <translation>この腕は細すぎてふくらみません：{}。{} にしますか？</translation>
    </message>
    <message>
        <source>This arm stays much thinner than the rest: drawn {width} wide, it becomes {measured} thick. For a rounder one make it {wanted} wide.</source>
        <translation>この腕はほかよりずっと細いままです。描いた幅は {width}、ふくらむ厚みは {measured} です。もっと丸くするには幅を {wanted} にしてください。</translation>
    </message>
    <message>
        <source>This balloon has not been worked out yet: start the study again.</source>
        <translation>この風船はまだ計算されていません。スタディをもう一度始めてください。</translation>
    </message>
    <message>
        <source>This balloon holds less than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>この風船に入るのは、フィルムに合うどの圧力でも {0} より少ない量です（{2} で {1}）。風船の大きさか体積を変えてください。</translation>
    </message>
    <message>
        <source>This balloon holds more than {0} at any pressure that suits its film: {1} at {2}. Change the size of the balloon or the volume.</source>
        <translation>この風船に入るのは、フィルムに合うどの圧力でも {0} より多い量です（{2} で {1}）。風船の大きさか体積を変えてください。</translation>
    </message>
    <message>
        <source>This cannot be shown ({0}).</source>
        <translation>これは表示できません（{0}）。</translation>
    </message>
    <message>
        <source>This gas is not lighter than the air around, so the balloon never floats: choose another gas or a higher temperature of the gas.</source>
        <translation>この気体はまわりの空気より軽くないので、風船は浮きません。別の気体か、高い温度にしてください。</translation>
    </message>
    <message>
        <source>This gives no whole number: {}</source>
        <translation>整数になりません：{}</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours, and its details cannot be written anywhere. Please report it: {0}, {1}.</source>
        <translation>これはプログラムの不具合で、あなたのせいではありません。詳細はどこにも書き込めませんでした。次の内容を報告してください：{0}、{1}。</translation>
    </message>
    <message>
        <source>This is a fault of the program, not yours. Its details are in '{0}': please report it with this file.</source>
        <translation>これはプログラムの不具合で、あなたのせいではありません。詳細は「{0}」にあります。このファイルを添えて報告してください。</translation>
    </message>
    <message>
        <source>This is shape {0} of the {1} in the drawing.</source>
        <translation>これは図の {1} 個の形のうち {0} 番目です。</translation>
    </message>
    <message>
        <source>This neck chokes the air: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. Make it {wanted} wide.</source>
        <translation>このくびれが空気の通りを妨げます。中の広さは幅 {measured} のフィルムの管と同じで、注入口は {intake} です。風船の {behind} がここを通ってふくらみます。幅を {wanted} にしてください。</translation>
    </message>
    <message>
        <source>This neck is too thin to let the air through: {}. Make it {}?</source>
        <translation>このくびれは細すぎて空気が通りません：{}。{} にしますか？</translation>
    </message>
    <message>
        <source>This neck slows the filling: inside it is as wide as a tube of {measured} of film, the intake is {intake}. {behind} of the balloon fill through it. For quicker filling make it {wanted} wide.</source>
        <translation>このくびれのためにふくらむのが遅くなります。中の広さは幅 {measured} のフィルムの管と同じで、注入口は {intake} です。風船の {behind} がここを通ってふくらみます。早くふくらませるには幅を {wanted} にしてください。</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere, so that it wrinkles there. A radius of {wanted} eases that.</source>
        <translation>この切れ込みではフィルムの張りがほかの {measured} になり、しわが寄ります。半径を {wanted} にすると軽くなります。</translation>
    </message>
    <message>
        <source>This notch pulls the film {measured} as tight as elsewhere; it wrinkles there and is where it would tear. Round it with a radius of {wanted}.</source>
        <translation>この切れ込みではフィルムの張りがほかの {measured} になり、しわが寄って破れやすくなります。半径 {wanted} で丸めてください。</translation>
    </message>
    <message>
        <source>This row is not worked out: choose Work out.</source>
        <translation>この行は計算されていません。「計算する」を選んでください。</translation>
    </message>
    <message>
        <source>This shape does not tell a stretch of the film from a weld that draws the seam inward: it is either a stretch of {0}, or a weld that draws it inward by {1}.</source>
        <translation>この形では、フィルムの伸びと、溶着で継ぎ目が内側へ寄ることを区別できません。伸びなら {0}、内側へ寄る量なら {1} です。</translation>
    </message>
    <message>
        <source>This shape stays flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>この形は平らなままです。同じ量のフィルムで作る丸い風船に比べ、空気は {percent} しか入りません。部分を減らし、広くすると丸くなります。</translation>
    </message>
    <message>
        <source>This shape stays rather flat: it holds {percent} of the air that a round balloon of as much film would. Fewer and wider parts make it rounder.</source>
        <translation>この形はやや平らなままです。入る空気は、同じ量のフィルムで作る丸い風船の {percent} です。部分を減らし、広くすると丸くなります。</translation>
    </message>
    <message>
        <source>This tip stays flat over {length}: it is too pointed. Round it with a radius of {wanted}.</source>
        <translation>この先端は {length} にわたって平らなままです。とがりすぎなので、半径 {wanted} で丸めてください。</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>しきい値</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, and to it a weight heavier than the {lift} that {gas} lifts. No metallic ribbon on foil, never let it fly.</source>
        <translation>首にリボンを結び、{gas} の浮力 {lift} より重い重しを付けます。アルミのフィルムに金属のリボンは使わず、決して空へ放さないでください。</translation>
    </message>
    <message>
        <source>Tie a ribbon round the neck, to hang it up or to hold it: it does not float.</source>
        <translation>首にリボンを結び、つるすか手に持ちます。この風船は浮きません。</translation>
    </message>
    <message>
        <source>Tip that stays flat</source>
        <translation>平らなままの先端</translation>
    </message>
    <message>
        <source>To</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>To cut, your settings of {cut_machine}: {cut}.</source>
        <translation>切るとき、自分の {cut_machine} の設定：{cut}。</translation>
    </message>
    <message>
        <source>To let the gas out, cut the seal across the neck off.</source>
        <translation>気体を抜くには、首を横切る溶着を切り落とします。</translation>
    </message>
    <message>
        <source>To let the gas out, push a straw in through the neck until it hisses, and press gently. Keep the balloon flat, not folded: it can be filled again.</source>
        <translation>気体を抜くには、首からストローをシューと音がするまで差し込み、そっと押します。風船は折らずに平らにしてしまいます。またふくらませることができます。</translation>
    </message>
    <message>
        <source>To this value, with its unit</source>
        <translation>この値まで（単位付き）</translation>
    </message>
    <message>
        <source>To weld, your settings of {weld_machine}: {weld}.</source>
        <translation>溶着するとき、自分の {weld_machine} の設定：{weld}。</translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels of one shape: </source>
        <translation>公差は一つの形の同じパネル 2 枚について計算します。</translation>
    </message>
    <message>
        <source>Tolerances are worked out for two equal panels, of which one is simulated: leave out --two-panels, and take a drawing.</source>
        <translation>公差は同じパネル 2 枚のうち 1 枚をシミュレートして計算します。--two-panels を外し、図を使ってください。</translation>
    </message>
    <message>
        <source>Too many samples could not be made to say which pressure 95 of 100 balloons bear.</source>
        <translation>作れなかったサンプルが多すぎて、100 個中 95 個の風船が耐える圧力を言えません。</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>Tool paths</source>
        <translation>ツールパス</translation>
    </message>
    <message>
        <source>Tool paths are not split over beds: write the G-code, or choose a larger bed.</source>
        <translation>ツールパスは加工台ごとに分けられません。G コードを書き出すか、もっと大きい加工台を選んでください。</translation>
    </message>
    <message>
        <source>Tool paths, no file</source>
        <translation>ツールパスだけ（ファイルなし）</translation>
    </message>
    <message>
        <source>Tracing paper, 92 g/m²</source>
        <translation>トレーシングペーパー、92 g/m²</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} has no area. Mesh the panel anew.</source>
        <translation>パネル{1}の三角形{0}に面積がありません。パネルのメッシュを作り直してください。</translation>
    </message>
    <message>
        <source>Triangle {0} of panel {1} runs clockwise. Mesh the panel anew.</source>
        <translation>パネル{1}の三角形{0}が時計回りです。パネルのメッシュを作り直してください。</translation>
    </message>
    <message>
        <source>Triangles of the mesh that lay on others were left out: {0}.</source>
        <translation>ほかと重なっていたため省いたメッシュの三角形：{0}。</translation>
    </message>
    <message>
        <source>Triangles of the mesh that stood on its surface, or were walls inside it, were left out: {0}.</source>
        <translation>表面に立っていたか内側の壁だったため省いたメッシュの三角形：{0}。</translation>
    </message>
    <message>
        <source>Triangles of the mesh that were the wrong way round were turned: {0}.</source>
        <translation>裏返しだったため向きを直したメッシュの三角形：{0}。</translation>
    </message>
    <message>
        <source>Triangles of the mesh whose points are no numbers were left out: {0}.</source>
        <translation>点が数でないため省いたメッシュの三角形：{0}。</translation>
    </message>
    <message>
        <source>Triangles that crossed others were cut out, and closed: {0}.</source>
        <translation>ほかと交わっていたため切り取り、穴をふさいだ三角形：{0}。</translation>
    </message>
    <message>
        <source>True length</source>
        <translation>実際の長さ</translation>
    </message>
    <message>
        <source>Try temperature and time on two scraps: the weld must stretch or tear before it opens.</source>
        <translation>端切れ 2 枚で温度と時間を試します。溶着したところが、はがれる前に伸びるか破れれば合格です。</translation>
    </message>
    <message>
        <source>Turn piece</source>
        <translation>部品を回転</translation>
    </message>
    <message>
        <source>Turning axis</source>
        <translation>回転軸</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>折り返し</translation>
    </message>
    <message>
        <source>Turns a minute; empty: not known yet</source>
        <translation>毎分の回転数。空ならまだ不明</translation>
    </message>
    <message>
        <source>Twelve panels that follow a solid: change its sizes in the spreadsheet</source>
        <translation>ソリッドに沿う 12 枚のパネル：寸法を表計算シートで変えてみてください</translation>
    </message>
    <message>
        <source>Two circles: change their diameters in the sketch</source>
        <translation>二つの円：スケッチで直径を変えられます</translation>
    </message>
    <message>
        <source>Two equal panels have one seam: what is said of the seam or edge of the opening has no effect. Say the direction of the intake, or its place along the seam.</source>
        <translation>同じ 2 枚のパネルの継ぎ目は 1 本です。開口の継ぎ目や辺の指定は効きません。注入口の向きか、継ぎ目に沿った位置を指定してください。</translation>
    </message>
    <message>
        <source>Two equal panels lie flat and have no lower end. Give lift to a standing body.</source>
        <translation>同じ 2 枚のパネルは平らで下端がありません。浮力は立っている立体に指定してください。</translation>
    </message>
    <message>
        <source>Two panels</source>
        <translation>2 枚のパネル</translation>
    </message>
    <message>
        <source>Two panels of the JSON file are called '{0}'. Give each a name of its own.</source>
        <translation>JSON ファイルに「{0}」というパネルが 2 つあります。別々の名前にしてください。</translation>
    </message>
    <message>
        <source>Two panels with a grain aslant are no mirror images. Turn the grain along x or y.</source>
        <translation>流れ方向が斜めの 2 枚は鏡像になりません。流れ方向を x か y に合わせてください。</translation>
    </message>
    <message>
        <source>Two shapes meet at {0}; part them, or join them into one.</source>
        <translation>二つの形が {0} で触れています。離すか、一つにしてください。</translation>
    </message>
    <message>
        <source>Type = for an expression</source>
        <translation>= で式を入力</translation>
    </message>
    <message>
        <source>Type two places for a cut, such as 10 0 50; 10 20 50, or choose a seam and type one.</source>
        <translation>切るなら 2 つの位置を 10 0 50; 10 20 50 のように入力するか、継ぎ目を選んで位置を 1 つ入力します。</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Undo (Ctrl+Z)</source>
        <translation>元に戻す（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Uniform errors along a seam need scipy: pip install scipy.</source>
        <translation>継ぎ目に沿った一様な誤差には scipy が必要です：pip install scipy。</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Unit of the numbers in its files</source>
        <translation>この機械のファイルにある数の単位</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Upload the SVG as a cut image and compare the control bar: some versions read the size at 72 dpi. Nothing is in the file that may not be cut. It adds the knife's offset and overcut itself. Design Space prints marks of its own (Print Then Cut), round at most 9.25 x 6.75 in: a print has none, and is refused where it is larger. Where yours takes more, raise most_mm in a copy.</source>
        <translation>SVG をカット画像としてアップロードし、確認用の棒と比べてください。大きさを 72 dpi で読む版もあります。切ってはいけないものはファイルに入っていません。刃のオフセットとオーバーカットは自分で加えます。Design Space は独自の印を印刷します（Print Then Cut）。最大 9.25 x 6.75 インチを囲むため、印刷には印を入れず、それより大きい印刷は受け付けません。お使いの版がもっと大きくてもよければ、コピーした機械の most_mm を大きくしてください。</translation>
    </message>
    <message>
        <source>Upper end</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>Use it as --machine {0}; in FreeCAD it is among the machines.</source>
        <translation>--machine {0} として使えます。FreeCAD では機械の一覧にあります。</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>使用率</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値の数</translation>
    </message>
    <message>
        <source>Valve film</source>
        <translation>弁のフィルム</translation>
    </message>
    <message>
        <source>Valve, on one panel</source>
        <translation>弁（片方のフィルムの上）</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>変えるもの</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>Volume of the body: {0}, the balloon has {1} of it</source>
        <translation>立体の体積：{0}、風船の体積はその {1}</translation>
    </message>
    <message>
        <source>Warm air</source>
        <translation>熱気</translation>
    </message>
    <message>
        <source>Water column</source>
        <translation>水柱</translation>
    </message>
    <message>
        <source>Weakest place</source>
        <translation>最も弱い所</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}</source>
        <translation>最も弱い所：{0}（位置 {1}）</translation>
    </message>
    <message>
        <source>Weakest place: {0} at {1}, estimated: the film did not come to rest</source>
        <translation>最も弱い所：{0}（位置 {1}）、推定値：フィルムが静止しませんでした</translation>
    </message>
    <message>
        <source>Web page that turns the balloon (HTML)</source>
        <translation>風船を回せるウェブページ (HTML)</translation>
    </message>
    <message>
        <source>Weight</source>
        <translation>重さ</translation>
    </message>
    <message>
        <source>Weight of film, welds and valve</source>
        <translation>フィルム、溶着、バルブの重さ</translation>
    </message>
    <message>
        <source>Weld</source>
        <translation>溶着線</translation>
    </message>
    <message>
        <source>Weld TPU to TPU with an iron or hot air, 10 mm wide. Warp and weft are stiff, the bias is soft: the model takes one modulus for all directions. Stiffer after the first inflations.</source>
        <translation>TPU どうしをアイロンか熱風で幅 10 mm に溶着します。縦糸と横糸の方向は硬く、斜めは柔らかいですが、モデルは全方向に一つの値を使います。数回ふくらませると硬くなります。</translation>
    </message>
    <message>
        <source>Weld across the neck along its line, through panels and strips: the field keeps the channel open. Pull the slip out and blow through the valve.</source>
        <translation>首を横切る線に沿って、フィルムと帯を一緒に溶着します。印の枠が通り道を開けておきます。小片を抜き、弁に息を吹き込みます。</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide, all the way round.</source>
        <translation>破線に沿って幅 {seal} で、ぐるりと 1 周溶着します。</translation>
    </message>
    <message>
        <source>Weld along the dashed line, {seal} wide. Leave the mouth of the neck open.</source>
        <translation>破線に沿って幅 {seal} で溶着します。首の口は開けておきます。</translation>
    </message>
    <message>
        <source>Weld and cut</source>
        <translation>溶着と切断</translation>
    </message>
    <message>
        <source>Weld overrun</source>
        <translation>溶着の重なり</translation>
    </message>
    <message>
        <source>Weld rigidity</source>
        <translation>溶着線の剛性</translation>
    </message>
    <message>
        <source>Weld the lines inside the balloon.</source>
        <translation>風船の内側の線を溶着します。</translation>
    </message>
    <message>
        <source>Weld the two strips together along their lines; over the marked field, heat-resistant ink or a slip of baking paper keeps the channel open. Tack them to one panel, their end at the mouth; then weld round the balloon and across the neck. Fill with a 6 mm tube: the pressure closes the strips.</source>
        <translation>帯 2 本を線に沿って溶着します。印の枠では、耐熱インクかクッキングシートの小片が通り道を開けておきます。端を口に合わせて片方のフィルムに仮留めし、それから風船のまわりと首を横切る線を溶着します。6 mm の管でふくらませると、内圧が帯を閉じます。</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide, all the way round.</source>
        <translation>高周波で、破線に沿って幅 {seal} で、ぐるりと 1 周溶着します。</translation>
    </message>
    <message>
        <source>Weld with high frequency along the dashed line, {seal} wide; leave the mouth of the neck open.</source>
        <translation>高周波で、破線に沿って幅 {seal} で溶着します。首の口は開けておきます。</translation>
    </message>
    <message>
        <source>Weld: {}</source>
        <translation>溶着: {}</translation>
    </message>
    <message>
        <source>Welded across, last</source>
        <translation>最後に横切って溶着</translation>
    </message>
    <message>
        <source>Welding</source>
        <translation>溶着</translation>
    </message>
    <message>
        <source>Welding: {0}</source>
        <translation>溶着：{0}</translation>
    </message>
    <message>
        <source>Welds easily with an impulse sealer or an iron. Yields at about 9 MPa, half its tensile strength, and creeps: keep the pressure low.</source>
        <translation>インパルスシーラーかアイロンで簡単に溶着できます。引張強さの半分の約 9 MPa で降伏し、クリープするので、圧力は低くしてください。</translation>
    </message>
    <message>
        <source>What</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>What is behind the balloon</source>
        <translation>風船の後ろに見えるもの</translation>
    </message>
    <message>
        <source>What is cut is a line in the spot colour CutContour, which prints over the picture and leaves no gap in it. With artwork both are in artwork-print-and-cut-pdf.pdf. The shop's program adds marks of its own.</source>
        <translation>切る線は特色 CutContour の線で、絵の上に重なり、絵に抜けを作りません。絵柄があれば、両方が artwork-print-and-cut-pdf.pdf に入ります。業者のプログラムが独自の印を加えます。</translation>
    </message>
    <message>
        <source>What is left of other film is of one film: choose patterns of one film for it.</source>
        <translation>残材は 1 種類のフィルムです。残材を使うには、1 種類のフィルムの型紙だけを選んでください。</translation>
    </message>
    <message>
        <source>What it can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit</source>
        <translation>加工できる大きさ。600 x 400 mm、ロールなら 600 mm など。制限がなければ空</translation>
    </message>
    <message>
        <source>What it holds</source>
        <translation>取り付けた工具</translation>
    </message>
    <message>
        <source>What it takes to make it</source>
        <translation>作るのに必要なもの</translation>
    </message>
    <message>
        <source>What most shops ask for: R12, closed polylines, nothing on the sheet that is not cut. R12 knows no unit, so the file's name tells it.</source>
        <translation>多くの業者が求める形式です。R12、閉じたポリライン、切らない線はなし。R12 には単位がないので、ファイル名に書きます。</translation>
    </message>
    <message>
        <source>What shows the balloon</source>
        <translation>風船を見せるもの</translation>
    </message>
    <message>
        <source>What the chosen gas carries besides</source>
        <translation>選んだ気体がさらに持ち上げる重さ</translation>
    </message>
    <message>
        <source>What this film costs, without what is left over</source>
        <translation>このフィルムの費用（余りを除く）</translation>
    </message>
    <message>
        <source>What this gas costs</source>
        <translation>この気体の費用</translation>
    </message>
    <message>
        <source>What this machine can work on, such as 600 x 400 mm, or 600 mm for a roll; empty where there is no limit. It is kept for this machine</source>
        <translation>この機械で加工できる大きさです。600 x 400 mm、ロールなら 600 mm のように書き、制限がなければ空にします。この機械の値として保存されます</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>この環境で使えるもの</translation>
    </message>
    <message>
        <source>What you want to read when you choose this machine, such as film and separating layer</source>
        <translation>この機械を選ぶときに読みたいこと（フィルムと敷き物など）</translation>
    </message>
    <message>
        <source>What {0} sent is not the native solver of this release: its SHA-256 is another one. It was not kept. {1}</source>
        <translation>{0} から届いたものは、SHA-256 が違うので、この版のネイティブソルバーではありません。保存しませんでした。{1}</translation>
    </message>
    <message>
        <source>When all shards are done, --collect writes the table.</source>
        <translation>すべての分割が終わったら、--collect で表を書き出せます。</translation>
    </message>
    <message>
        <source>Where an edge is cut into tabs, turn it round the other one tab by tab while you seal.</source>
        <translation>辺がタブに切られている所は、溶着しながらタブを 1 つずつもう一方の辺に折り返します。</translation>
    </message>
    <message>
        <source>Where the film wrinkles</source>
        <translation>しわが寄る所</translation>
    </message>
    <message>
        <source>Whether the {0} of the intake's pieces welds to {1} is not known: try it on a scrap first.</source>
        <translation>注入口の部品の {0} が {1} と溶着するかどうかは不明です。先に端切れで試してください。</translation>
    </message>
    <message>
        <source>While this is pressed, the edge that you pick is where it is filled</source>
        <translation>押している間は、選んだ辺が空気を入れる辺になります</translation>
    </message>
    <message>
        <source>While this is pressed, the ring in the 3D view moves the intake</source>
        <translation>押している間、3D ビューの輪で注入口を動かせます</translation>
    </message>
    <message>
        <source>While this is pressed, what you select becomes the source</source>
        <translation>押している間、選んだものが元の形になります</translation>
    </message>
    <message>
        <source>White</source>
        <translation>白</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width hidden in wrinkles</source>
        <translation>しわに隠れた幅</translation>
    </message>
    <message>
        <source>Width of film that the beam or cutter takes away: cuts are moved outward by half of it</source>
        <translation>ビームやカッターで失われるフィルムの幅：切り線はその半分だけ外側へ動きます</translation>
    </message>
    <message>
        <source>Width of the balloon when it is inflated</source>
        <translation>ふくらんだときの風船の幅</translation>
    </message>
    <message>
        <source>Will it float?</source>
        <translation>浮く？</translation>
    </message>
    <message>
        <source>Will it float? {0}</source>
        <translation>浮く？{0}</translation>
    </message>
    <message>
        <source>With --scale {0} the size tells nothing of the film: give the photograph's scale to fit it.</source>
        <translation>--scale {0} では、大きさからフィルムのことは分かりません。フィルムを合わせるには写真の縮尺を指定してください。</translation>
    </message>
    <message>
        <source>With a side band the balloon of this drawing becomes {0} to {1} thick, not {2}. Choose a thickness between, or draw its parts wider or narrower.</source>
        <translation>側面の帯を付けるとこの図の風船の厚さは {0}～{1} になり、{2} にはなりません。その間の厚さを選ぶか、図の部分の幅を変えてください。</translation>
    </message>
    <message>
        <source>With so few samples, {0}, nobody can say which pressure 95 of 100 balloons bear: take {1} or more.</source>
        <translation>100 個中 95 個の風船が耐える圧力を言うには、サンプル {0} では足りません。{1} 以上にしてください。</translation>
    </message>
    <message>
        <source>With the fonts of this computer {0} cannot be drawn, letter by letter from left to right: leave that out of the label, or install a font that has it and start again.</source>
        <translation>このコンピューターのフォントでは {0} を左から右へ 1 字ずつ描けません。文字から除くか、それのあるフォントを入れて起動し直してください。</translation>
    </message>
    <message>
        <source>With {0} panels some would cross themselves when laid flat: the body has {1}.</source>
        <translation>パネル {0} 枚では、平らに広げると自分と交わるものがあります。立体のパネルを {1} 枚にしました。</translation>
    </message>
    <message>
        <source>With {0} to {1} panels some would cross themselves when laid flat: give more panels.</source>
        <translation>パネル {0}～{1} 枚では、平らに広げると自分と交わるものがあります。パネルを増やしてください。</translation>
    </message>
    <message>
        <source>Within</source>
        <translation>許容範囲</translation>
    </message>
    <message>
        <source>Without this seam panel {0} goes round the body and cannot be laid flat.</source>
        <translation>この継ぎ目がないと、パネル {0} は立体を一周し、平らに広げられません。</translation>
    </message>
    <message>
        <source>Work out</source>
        <translation>計算する</translation>
    </message>
    <message>
        <source>Work out how near balloons of 6 to 60 panels come to the body</source>
        <translation>パネル 6～60 枚の風船が立体にどれだけ近づくかを計算する</translation>
    </message>
    <message>
        <source>Wrinkles</source>
        <translation>しわ</translation>
    </message>
    <message>
        <source>Write all results for ParaView (.vtu) or NumPy (.npz), or the shape alone (.stl)</source>
        <translation>すべての結果を ParaView（.vtu）か NumPy（.npz）用に、または形だけを（.stl）書き出す</translation>
    </message>
    <message>
        <source>Write anyway</source>
        <translation>それでも書き出す</translation>
    </message>
    <message>
        <source>Write files…</source>
        <translation>ファイルを書き出す…</translation>
    </message>
    <message>
        <source>Write several files, each as large as the bed. Crosses in waste film tell how the film is laid on anew for the next one</source>
        <translation>加工台の大きさごとに複数のファイルを書き出します。捨てるフィルムの十字で、次のファイルのためにフィルムをどう置き直すかが分かります</translation>
    </message>
    <message>
        <source>Write the file although it is larger than the bed</source>
        <translation>加工台より大きくてもファイルを書き出します</translation>
    </message>
    <message>
        <source>Write the pieces as they lie, and the artwork if it is shown, to a PDF in real size</source>
        <translation>並べたままの部品を、絵柄を表示しているときは絵柄も、原寸で PDF に書き出します</translation>
    </message>
    <message>
        <source>Write these frames as a moving picture, with the artwork, on white</source>
        <translation>このコマを、印刷つき、白い背景の動画として書き出します</translation>
    </message>
    <message>
        <source>Write what is left of the film to a file, for another layout</source>
        <translation>フィルムの残りを、別の配置に使えるファイルに書き出します</translation>
    </message>
    <message>
        <source>Write {"a": ["top", 0, 1], "b": ["side", 3, 2]}.</source>
        <translation>{"a": ["top", 0, 1], "b": ["side", 3, 2]} と書いてください。</translation>
    </message>
    <message>
        <source>Write {"do": "add", "at": [[0.3, 0.5]]}.</source>
        <translation>{"do": "add", "at": [[0.3, 0.5]]} のように書いてください。</translation>
    </message>
    <message>
        <source>Write {"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]}.</source>
        <translation>{"do": "cut", "at": [[0, 0, 50], [100, 0, 20]]} のように書いてください。</translation>
    </message>
    <message>
        <source>Write {"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>{"name": "top", "outer": [[0, 0], [300, 0], [150, 200]]} と書いてください。</translation>
    </message>
    <message>
        <source>Write {"panel": "side", "at": 2}.</source>
        <translation>{"panel": "side", "at": 2} と書いてください。</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]}.</source>
        <translation>{"unit": "mm", "outer": [[0, 0], [300, 0], [150, 200]]} のように書いてください。</translation>
    </message>
    <message>
        <source>Write {"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]}.</source>
        <translation>{"unit": "mm", "profile": [[0, 0], [150, 200], [0, 400]]} と書いてください。</translation>
    </message>
    <message>
        <source>Writing DXF needs ezdxf: install it with pip install ezdxf, or use the SVG file.</source>
        <translation>DXF の書き出しには ezdxf が必要です。pip install ezdxf で入れるか、SVG を使ってください。</translation>
    </message>
    <message>
        <source>Writing PDF needs matplotlib: install it with pip install matplotlib, or use the SVG file.</source>
        <translation>PDFの書き出しにはmatplotlibが必要です。pip install matplotlibでインストールするか、SVGファイルを使ってください。</translation>
    </message>
    <message>
        <source>Writing the test card</source>
        <translation>テストカードを書き出しています</translation>
    </message>
    <message>
        <source>Writing {0}</source>
        <translation>{0} を書き出しています</translation>
    </message>
    <message>
        <source>Written to {}</source>
        <translation>{} に書き出しました</translation>
    </message>
    <message>
        <source>Written to {}, in real size on {}: print it at 100 %.</source>
        <translation>{} に原寸（{}）で書き出しました。100 % で印刷してください。</translation>
    </message>
    <message>
        <source>Wrote {0}</source>
        <translation>{0} を書き出しました</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>You paint on: {}</source>
        <translation>いま描いているのは：{}</translation>
    </message>
    <message>
        <source>Young's modulus</source>
        <translation>ヤング率</translation>
    </message>
    <message>
        <source>Young's modulus across the grain</source>
        <translation>流れに直角のヤング率</translation>
    </message>
    <message>
        <source>Young's modulus of the film</source>
        <translation>フィルムのヤング率</translation>
    </message>
    <message>
        <source>Zünd Cut Center (flat bed)</source>
        <translation>Zünd Cut Center（フラットベッド）</translation>
    </message>
    <message>
        <source>["200mm", "300mm"], {"linspace": ["1kPa", "3kPa", 5]} with how many, {"range": [6, 12, 2]} with the step, {"between": ["1kPa", "3kPa"]} for samples, or {"glob": "drawings/*.png"}</source>
        <translation>["200mm", "300mm"]、個数付きの {"linspace": ["1kPa", "3kPa", 5]}、刻み付きの {"range": [6, 12, 2]}、サンプル用の {"between": ["1kPa", "3kPa"]}、または {"glob": "drawings/*.png"}</translation>
    </message>
    <message>
        <source>a LightBurn project has layers up to {0}: change the pen.</source>
        <translation>LightBurn プロジェクトのレイヤーは {0} までです。ペンを変えてください。</translation>
    </message>
    <message>
        <source>a body consists of itself, or of one that is not there</source>
        <translation>立体が自分自身か、存在しない立体でできている</translation>
    </message>
    <message>
        <source>a body hangs together</source>
        <translation>立体はひとつながりである</translation>
    </message>
    <message>
        <source>a comma, quote or bracket is missing or too much in line {0}</source>
        <translation>{0} 行目でコンマ、引用符、括弧のどれかが足りないか、多すぎます</translation>
    </message>
    <message>
        <source>a coordinate is not a number</source>
        <translation>数ではない座標がある</translation>
    </message>
    <message>
        <source>a density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>a face is no list of points.</source>
        <translation>点の並びでない面があります。</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>a loop is no list of at least three points [x, y].</source>
        <translation>境界が 3 点以上の [x, y] の並びになっていません。</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>a number without a unit</source>
        <translation>単位のない数</translation>
    </message>
    <message>
        <source>a point is no three numbers.</source>
        <translation>3 つの数でない点があります。</translation>
    </message>
    <message>
        <source>a pressure</source>
        <translation>圧力</translation>
    </message>
    <message>
        <source>a sleeve has an end</source>
        <translation>筒には端がある</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>a transform is not a number</source>
        <translation>変換が数ではない</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>a {0} file has a unit of its own: give "unit": "mm".</source>
        <translation>{0} ファイルには自分の単位があります。"unit": "mm" にしてください。</translation>
    </message>
    <message>
        <source>about {}</source>
        <translation>約 {}</translation>
    </message>
    <message>
        <source>about {} x {}, {} thick, {}</source>
        <translation>約 {} x {}、厚み {}、{}</translation>
    </message>
    <message>
        <source>air</source>
        <translation>空気</translation>
    </message>
    <message>
        <source>all files were written before to {0}</source>
        <translation>ファイルはその前にすべて {0} に書き出しました</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>面積</translation>
    </message>
    <message>
        <source>another run has been writing there for a minute</source>
        <translation>1 分前から別の実行が書き込んでいます</translation>
    </message>
    <message>
        <source>another unit</source>
        <translation>別の単位</translation>
    </message>
    <message>
        <source>any accuracy</source>
        <translation>精度の指定なし</translation>
    </message>
    <message>
        <source>apart {} in the mean, 95 % below {}, at most {}</source>
        <translation>隔たりは平均 {}、95 % が {} 以下、最大 {}</translation>
    </message>
    <message>
        <source>areal density</source>
        <translation>面密度</translation>
    </message>
    <message>
        <source>artwork.pdf was left out. {0}</source>
        <translation>artwork.pdf を省きました。{0}</translation>
    </message>
    <message>
        <source>as made is larger</source>
        <translation>実物の方が大きい</translation>
    </message>
    <message>
        <source>as made is smaller</source>
        <translation>実物の方が小さい</translation>
    </message>
    <message>
        <source>at most </source>
        <translation>最大 </translation>
    </message>
    <message>
        <source>at most {0}</source>
        <translation>最大 {0}</translation>
    </message>
    <message>
        <source>at most {} ({})</source>
        <translation>最大 {}（{}）</translation>
    </message>
    <message>
        <source>at most {} {}</source>
        <translation>最大 {} {}</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>back</source>
        <translation>裏</translation>
    </message>
    <message>
        <source>baking paper</source>
        <translation>クッキングシート</translation>
    </message>
    <message>
        <source>balloon {0} of {1}</source>
        <translation>風船 {0}/{1}</translation>
    </message>
    <message>
        <source>balloon {0} of {1} at most</source>
        <translation>風船 {0}/最大 {1}</translation>
    </message>
    <message>
        <source>balloon {0} of {1}, {2}</source>
        <translation>風船 {0}/{1}、{2}</translation>
    </message>
    <message>
        <source>balloons</source>
        <translation>風船</translation>
    </message>
    <message>
        <source>bar or iron {0}</source>
        <translation>バーかアイロン {0}</translation>
    </message>
    <message>
        <source>bed_mm is {0}: give [width, height], [width, null] for a roll, or null where there is no limit.</source>
        <translation>bed_mm が {0} です。[幅, 高さ]、ロールなら [幅, null]、制限がなければ null にしてください。</translation>
    </message>
    <message>
        <source>both lie on borders of one piece</source>
        <translation>両方とも同じ部分の縁にある</translation>
    </message>
    <message>
        <source>choose Drawn as filled shape</source>
        <translation>「描き方」を「塗った形」にしてください</translation>
    </message>
    <message>
        <source>colour index {0} and pen {1} of {2} must be from 1 to 255.</source>
        <translation>{2} の色番号 {0} とペン {1} は 1～255 にしてください。</translation>
    </message>
    <message>
        <source>connecting</source>
        <translation>接続中</translation>
    </message>
    <message>
        <source>crosses for the eye</source>
        <translation>目で合わせる十字</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>切り線</translation>
    </message>
    <message>
        <source>cut inside</source>
        <translation>内側の切り線</translation>
    </message>
    <message>
        <source>cutting error</source>
        <translation>切断の誤差</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>designing a balloon</source>
        <translation>風船の設計</translation>
    </message>
    <message>
        <source>does not name its unit</source>
        <translation>単位が書かれていません</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>図</translation>
    </message>
    <message>
        <source>drawn mark</source>
        <translation>描いた印</translation>
    </message>
    <message>
        <source>dwell</source>
        <translation>待ち時間</translation>
    </message>
    <message>
        <source>edge {0} of {1}panel '{2}'</source>
        <translation>{1}パネル「{2}」の辺 {0}</translation>
    </message>
    <message>
        <source>edges {0} to {1}</source>
        <translation>辺 {0}～{1}</translation>
    </message>
    <message>
        <source>empty: </source>
        <translation>空：</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>送り速度</translation>
    </message>
    <message>
        <source>feed in corners</source>
        <translation>角での送り速度</translation>
    </message>
    <message>
        <source>fetch the native solver from the network, where the workbench came without it</source>
        <translation>ワークベンチにネイティブソルバーが付いていない場合に、ネットワークから取得する</translation>
    </message>
    <message>
        <source>fetching</source>
        <translation>取得中</translation>
    </message>
    <message>
        <source>few panels</source>
        <translation>少ないパネル</translation>
    </message>
    <message>
        <source>film</source>
        <translation>フィルム</translation>
    </message>
    <message>
        <source>film and valve weigh {0}</source>
        <translation>フィルムと弁の重さは {0}</translation>
    </message>
    <message>
        <source>fitted to {0}</source>
        <translation>{0} に合わせた値</translation>
    </message>
    <message>
        <source>fold</source>
        <translation>折り線</translation>
    </message>
    <message>
        <source>front</source>
        <translation>表</translation>
    </message>
    <message>
        <source>gas</source>
        <translation>気体</translation>
    </message>
    <message>
        <source>given by the user</source>
        <translation>使用者による指定値</translation>
    </message>
    <message>
        <source>glued seam</source>
        <translation>接着の継ぎ目</translation>
    </message>
    <message>
        <source>glued seam inside</source>
        <translation>内側の接着の継ぎ目</translation>
    </message>
    <message>
        <source>grain at {}°</source>
        <translation>流れ方向 {}°</translation>
    </message>
    <message>
        <source>height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>helium</source>
        <translation>ヘリウム</translation>
    </message>
    <message>
        <source>hide {} of the film's width</source>
        <translation>フィルムの幅の {} が隠れます</translation>
    </message>
    <message>
        <source>hint</source>
        <translation>ヒント</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>hole {0} of panel '{1}'</source>
        <translation>パネル「{1}」の穴 {0}</translation>
    </message>
    <message>
        <source>hot tip</source>
        <translation>熱いこて先</translation>
    </message>
    <message>
        <source>hot tip at {0}</source>
        <translation>熱したこて先 {0}</translation>
    </message>
    <message>
        <source>hot wheel</source>
        <translation>熱いローラー</translation>
    </message>
    <message>
        <source>hydrogen</source>
        <translation>水素</translation>
    </message>
    <message>
        <source>if the weld creases: {0}</source>
        <translation>溶着線にしわが寄る場合：{0}</translation>
    </message>
    <message>
        <source>in both sides of seam {0}</source>
        <translation>継ぎ目 {0} の両側にあります</translation>
    </message>
    <message>
        <source>in seams {0} and {1}</source>
        <translation>継ぎ目 {0} と {1} にあります</translation>
    </message>
    <message>
        <source>in the mean {}</source>
        <translation>平均 {}</translation>
    </message>
    <message>
        <source>in the mean {} ({})</source>
        <translation>平均 {}（{}）</translation>
    </message>
    <message>
        <source>in the mean {}, 95 % below {}, at most {}</source>
        <translation>平均 {}、95 % が {} 以下、最大 {}</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>保存先：{}</translation>
    </message>
    <message>
        <source>inflated</source>
        <translation>ふくらんだ形</translation>
    </message>
    <message>
        <source>inflated {0}, {1}</source>
        <translation>ふくらんだ大きさ {0}、{1}</translation>
    </message>
    <message>
        <source>inflating</source>
        <translation>膨張中</translation>
    </message>
    <message>
        <source>inflating in time</source>
        <translation>時間を追って膨張中</translation>
    </message>
    <message>
        <source>intake piece {0}</source>
        <translation>注入口の部品 {0}</translation>
    </message>
    <message>
        <source>it ends too early.</source>
        <translation>途中で終わっています。</translation>
    </message>
    <message>
        <source>it has {0} shapes: give 1 to {1}.</source>
        <translation>形が {0} 個あります。1～{1} 個にしてください。</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>入れ子が深すぎます</translation>
    </message>
    <message>
        <source>it is no file</source>
        <translation>ファイルではありません</translation>
    </message>
    <message>
        <source>it is thinner than any film. Make it wider.</source>
        <translation>どのフィルムより細くなっています。広くしてください。</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>大きすぎます</translation>
    </message>
    <message>
        <source>it would grow together with another part</source>
        <translation>別の部分とつながってしまう</translation>
    </message>
    <message>
        <source>its header cannot be understood.</source>
        <translation>ヘッダーを読み取れません。</translation>
    </message>
    <message>
        <source>its header has no end.</source>
        <translation>ヘッダーに終わりがありません。</translation>
    </message>
    <message>
        <source>its lines cross or touch: give the edge of one piece of film, and its holes.</source>
        <translation>線が交わるか触れています。1 枚のフィルムの縁と、その穴を指定してください。</translation>
    </message>
    <message>
        <source>its points have lists.</source>
        <translation>点にリストが含まれています。</translation>
    </message>
    <message>
        <source>its points have no x, y and z.</source>
        <translation>点に x、y、z がありません。</translation>
    </message>
    <message>
        <source>knife</source>
        <translation>刃</translation>
    </message>
    <message>
        <source>known of two equal panels alone</source>
        <translation>同じ 2 枚のパネルでだけわかります</translation>
    </message>
    <message>
        <source>laser</source>
        <translation>レーザー</translation>
    </message>
    <message>
        <source>layer {0} of the LightBurn project has two speeds or powers: give its roles one.</source>
        <translation>LightBurn プロジェクトのレイヤー {0} に速度か出力が二つあります。その役割には同じ値を指定してください。</translation>
    </message>
    <message>
        <source>laying out</source>
        <translation>並べています</translation>
    </message>
    <message>
        <source>laying out, {0} so far</source>
        <translation>配置中、これまで {0}</translation>
    </message>
    <message>
        <source>lead-in</source>
        <translation>リードイン</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>less than</source>
        <translation>次の値より少なく</translation>
    </message>
    <message>
        <source>less than its {} with a margin of {} ({})</source>
        <translation>現在の {} 未満（余裕 {} 倍、{}）</translation>
    </message>
    <message>
        <source>lift</source>
        <translation>浮力</translation>
    </message>
    <message>
        <source>lift of the tool</source>
        <translation>工具の上昇量</translation>
    </message>
    <message>
        <source>line_mm of marks is {0}, and size_mm {1}: a line is at most half as wide as its mark.</source>
        <translation>印の line_mm が {0}、size_mm が {1} です。線の太さは印の大きさの半分までです。</translation>
    </message>
    <message>
        <source>loose: {}</source>
        <translation>たるみ：{}</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>下</translation>
    </message>
    <message>
        <source>making a balloon of a study</source>
        <translation>スタディの風船を作るとき</translation>
    </message>
    <message>
        <source>making the document</source>
        <translation>文書の作成</translation>
    </message>
    <message>
        <source>marks is {0}: give {"style": ...}, or leave it out for crosses.</source>
        <translation>marks が {0} です。{"style": ...} とするか、十字でよければ外してください。</translation>
    </message>
    <message>
        <source>marks of size_mm {0} and inset_mm {1} do not fit on a page_mm of {2}: give a larger page or smaller marks.</source>
        <translation>size_mm {0}、inset_mm {1} の印は page_mm {2} に収まりません。用紙を大きくするか、印を小さくしてください。</translation>
    </message>
    <message>
        <source>marks of style {0} have no "{1}": only {2}.</source>
        <translation>種類 {0} の印に "{1}" はありません。使えるのは {2} だけです。</translation>
    </message>
    <message>
        <source>marks of style {0} lack {1}: add it.</source>
        <translation>種類 {0} の印に {1} がありません。加えてください。</translation>
    </message>
    <message>
        <source>mass</source>
        <translation>質量</translation>
    </message>
    <message>
        <source>may be cut</source>
        <translation>切ってよい</translation>
    </message>
    <message>
        <source>min_power_percent of {0} is more than max_power_percent: exchange the two.</source>
        <translation>{0} の min_power_percent が max_power_percent より大きくなっています。二つを入れ替えてください。</translation>
    </message>
    <message>
        <source>mirrored: its other side is up, with its print and sealing side</source>
        <translation>反転：裏側が上になり、印刷とシール面も逆になります</translation>
    </message>
    <message>
        <source>more than</source>
        <translation>次の値より多く</translation>
    </message>
    <message>
        <source>moved at {0}</source>
        <translation>動かす速さ {0}</translation>
    </message>
    <message>
        <source>name a property of the balloon</source>
        <translation>風船のプロパティを指定してください</translation>
    </message>
    <message>
        <source>names the unit {0}, which is not a usual one</source>
        <translation>単位 {0} は一般的ではありません</translation>
    </message>
    <message>
        <source>near {0} two of its edges are closer than {1}, and their welds run into each other: make the balloon larger or the seal narrower.</source>
        <translation>{0} の近くで 2 つの辺の間が {1} より狭く、溶着が重なります。風船を大きくするか、溶着を細くしてください。</translation>
    </message>
    <message>
        <source>no</source>
        <translation>いいえ</translation>
    </message>
    <message>
        <source>no drawing to compare with</source>
        <translation>比べる図がありません</translation>
    </message>
    <message>
        <source>no file was written</source>
        <translation>ファイルは書き出していません</translation>
    </message>
    <message>
        <source>no layer is written: name at least CUT.</source>
        <translation>書き出すレイヤーがありません。少なくとも CUT を入れてください。</translation>
    </message>
    <message>
        <source>nobody knows "{0}" of a tool: it may be one of {1}.</source>
        <translation>工具の「{0}」は使えません。使えるもの：{1}。</translation>
    </message>
    <message>
        <source>nobody knows "{0}": it may be one of {1}.</source>
        <translation>「{0}」は使えません。使えるもの：{1}。</translation>
    </message>
    <message>
        <source>nobody knows the start value "{0}": it may be one of {1}.</source>
        <translation>最初に試す値 "{0}" は知られていません。{1} から選んでください。</translation>
    </message>
    <message>
        <source>not converged: </source>
        <translation>収束していません：</translation>
    </message>
    <message>
        <source>notch</source>
        <translation>合印</translation>
    </message>
    <message>
        <source>nothing is left that is large enough to be used again</source>
        <translation>また使えるほど大きな残りがありません</translation>
    </message>
    <message>
        <source>number for full power</source>
        <translation>最大出力を表す数</translation>
    </message>
    <message>
        <source>one of its values is of another kind than it must be</source>
        <translation>値の一つの種類が違います</translation>
    </message>
    <message>
        <source>only a PDF has spot colours: give "format": "pdf", or leave them out.</source>
        <translation>特色があるのは PDF だけです。"format": "pdf" とするか、特色を外してください。</translation>
    </message>
    <message>
        <source>opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>輪郭</translation>
    </message>
    <message>
        <source>outward of marks is {0}: write true or false.</source>
        <translation>印の outward が {0} です。true か false にしてください。</translation>
    </message>
    <message>
        <source>over</source>
        <translation>横軸</translation>
    </message>
    <message>
        <source>pass {0}: {1}</source>
        <translation>{0} 回目：{1}</translation>
    </message>
    <message>
        <source>passes of {0} is {1}: give a whole number.</source>
        <translation>{0} の passes が {1} です。整数にしてください。</translation>
    </message>
    <message>
        <source>pieces {0}, on a remnant of {1}, {2} used</source>
        <translation>部品 {0}、残材 {1} の上、使用率 {2}</translation>
    </message>
    <message>
        <source>pieces {0}, on {1}, {2} used</source>
        <translation>部品 {0}、{1} の上、使用率 {2}</translation>
    </message>
    <message>
        <source>place "{0}" is neither {1} nor {2}.</source>
        <translation>place「{0}」は {1} でも {2} でもありません。</translation>
    </message>
    <message>
        <source>power</source>
        <translation>出力</translation>
    </message>
    <message>
        <source>pressed for {0}</source>
        <translation>押す時間 {0}</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>圧力</translation>
    </message>
    <message>
        <source>pressure at filling</source>
        <translation>充填時の圧力</translation>
    </message>
    <message>
        <source>printing</source>
        <translation>印刷用データを作成中</translation>
    </message>
    <message>
        <source>reading the photograph</source>
        <translation>写真を読んでいます</translation>
    </message>
    <message>
        <source>reading the solid</source>
        <translation>ソリッドの読み込み</translation>
    </message>
    <message>
        <source>remnants {0}, {1}</source>
        <translation>残材 {0}、{1}</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>safe to {}, margin {}</source>
        <translation>{} まで安全、余裕 {} 倍</translation>
    </message>
    <message>
        <source>safe to: is being worked out</source>
        <translation>安全な圧力: 計算中</translation>
    </message>
    <message>
        <source>seal width</source>
        <translation>溶着幅</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>継ぎ目</translation>
    </message>
    <message>
        <source>seam inside</source>
        <translation>内側の継ぎ目</translation>
    </message>
    <message>
        <source>serious</source>
        <translation>重大</translation>
    </message>
    <message>
        <source>size {0}, {1}</source>
        <translation>大きさ {0}、{1}</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>speed of the spindle</source>
        <translation>主軸の回転速度</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>主軸</translation>
    </message>
    <message>
        <source>square_mm of marks is larger than size_mm, {0}: make it smaller.</source>
        <translation>印の square_mm が size_mm の {0} より大きくなっています。小さくしてください。</translation>
    </message>
    <message>
        <source>stale: </source>
        <translation>古い結果：</translation>
    </message>
    <message>
        <source>stale: belongs to earlier values</source>
        <translation>古い結果：以前の値のもの</translation>
    </message>
    <message>
        <source>start_values are of films that are welded by heat: give "joining": "heat" too.</source>
        <translation>start_values は熱で溶着するフィルムのものです。"joining": "heat" も指定してください。</translation>
    </message>
    <message>
        <source>start_values are {0}: give the values with their sources, or leave them out.</source>
        <translation>start_values が {0} です。値を出典とともに書くか、外してください。</translation>
    </message>
    <message>
        <source>stopped; {0}.</source>
        <translation>停止しました。{0}。</translation>
    </message>
    <message>
        <source>strain {}</source>
        <translation>ひずみ：{}</translation>
    </message>
    <message>
        <source>strength</source>
        <translation>強度</translation>
    </message>
    <message>
        <source>strength of film and weld</source>
        <translation>フィルムと溶着の強度</translation>
    </message>
    <message>
        <source>strength of the film not known</source>
        <translation>フィルムの強度が不明</translation>
    </message>
    <message>
        <source>such as {"normal": "{0}"}</source>
        <translation>例：{"normal": "{0}"}</translation>
    </message>
    <message>
        <source>taped seam</source>
        <translation>テープの継ぎ目</translation>
    </message>
    <message>
        <source>taped seam inside</source>
        <translation>内側のテープの継ぎ目</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>温度</translation>
    </message>
    <message>
        <source>temperature after filling</source>
        <translation>充填後の温度</translation>
    </message>
    <message>
        <source>test-card.json</source>
        <translation>test-card.json</translation>
    </message>
    <message>
        <source>the answer is not HTTP</source>
        <translation>応答が HTTP ではありません</translation>
    </message>
    <message>
        <source>the balloons that were made stay, and the same command goes on</source>
        <translation>作った風船は残り、同じコマンドで続きから始まります</translation>
    </message>
    <message>
        <source>the colour "{0}" is not written like #ff0000.</source>
        <translation>色「{0}」が #ff0000 の形になっていません。</translation>
    </message>
    <message>
        <source>the columns are the options of the command line</source>
        <translation>列はコマンドラインのオプションです</translation>
    </message>
    <message>
        <source>the connection ended too soon</source>
        <translation>接続が途中で切れました</translation>
    </message>
    <message>
        <source>the connection timed out</source>
        <translation>時間内に応答がありませんでした</translation>
    </message>
    <message>
        <source>the file name "{0}" may have letters, digits, spaces, _, - and . only.</source>
        <translation>ファイル名「{0}」に使えるのは英数字、空白、_、-、. だけです。</translation>
    </message>
    <message>
        <source>the film weighs {0}</source>
        <translation>フィルムの重さは {0}</translation>
    </message>
    <message>
        <source>the last line of each piece is its CUT.</source>
        <translation>各部品の最後の線は CUT です。</translation>
    </message>
    <message>
        <source>the layer name "{0}" may have 1 to 31 of A-Z, a-z, 0-9, _, - and $ only.</source>
        <translation>レイヤー名 "{0}" に使えるのは、A-Z、a-z、0-9、_、-、$ の 1～31 文字だけです。</translation>
    </message>
    <message>
        <source>the layer {0} lacks {1}: give speed and power together, or neither.</source>
        <translation>レイヤー {0} に {1} がありません。速度と出力を両方とも指定するか、両方とも外してください。</translation>
    </message>
    <message>
        <source>the marks of {0}</source>
        <translation>{0} の印</translation>
    </message>
    <message>
        <source>the name "{0}" of the stock goes into file names: take letters a to z.</source>
        <translation>材料の名前「{0}」はファイル名に使われます。a から z の文字にしてください。</translation>
    </message>
    <message>
        <source>the nearest are {0}</source>
        <translation>近いものは {0} です</translation>
    </message>
    <message>
        <source>the sealing side {0} is no polymer: give one such as "PE", or "none".</source>
        <translation>シール面 {0} はポリマーではありません。"PE" のように指定するか、"none" にしてください。</translation>
    </message>
    <message>
        <source>the separating layer "{0}" is none of {1}: take one.</source>
        <translation>敷き物 "{0}" は {1} のどれでもありません。その中から選んでください。</translation>
    </message>
    <message>
        <source>the spot colour "{0}" may have letters, digits, _ and - only.</source>
        <translation>特色 "{0}" に使えるのは英数字、_、- だけです。</translation>
    </message>
    <message>
        <source>the style of marks</source>
        <translation>印の種類</translation>
    </message>
    <message>
        <source>the tool "{0}" is none of {1}.</source>
        <translation>工具「{0}」は {1} のどれでもありません。</translation>
    </message>
    <message>
        <source>the weld rigidity lacks its source: write where it is from, or "assumed".</source>
        <translation>溶着線の剛性に出典がありません。出典を書くか、「assumed」としてください。</translation>
    </message>
    <message>
        <source>there is no model in it</source>
        <translation>モデルが入っていない</translation>
    </message>
    <message>
        <source>there is no such corner</source>
        <translation>そのような角がない</translation>
    </message>
    <message>
        <source>there is no such part</source>
        <translation>そのような部分がない</translation>
    </message>
    <message>
        <source>there is no unit "{0}": write "mm".</source>
        <translation>単位 "{0}" はありません。"mm" と書いてください。</translation>
    </message>
    <message>
        <source>thickness</source>
        <translation>厚さ</translation>
    </message>
    <message>
        <source>thickness of the film</source>
        <translation>フィルムの厚さ</translation>
    </message>
    <message>
        <source>thin PE film, 30 to 50 µm</source>
        <translation>薄い PE フィルム、30～50 µm</translation>
    </message>
    <message>
        <source>through a layer of {0}</source>
        <translation>{0} を間に敷いて</translation>
    </message>
    <message>
        <source>tight: {}</source>
        <translation>張り：{}</translation>
    </message>
    <message>
        <source>times that of flat film</source>
        <translation>倍（平らなフィルムを 1 とする）</translation>
    </message>
    <message>
        <source>trial of the pattern: {0}</source>
        <translation>型紙の試し：{0}</translation>
    </message>
    <message>
        <source>trial {0}, {1}</source>
        <translation>試行 {0}、{1}</translation>
    </message>
    <message>
        <source>true to shape</source>
        <translation>形に忠実</translation>
    </message>
    <message>
        <source>turned by {}°</source>
        <translation>{}° 回転</translation>
    </message>
    <message>
        <source>unknown: this film has no strength</source>
        <translation>不明：このフィルムには強度の値がありません</translation>
    </message>
    <message>
        <source>up to date</source>
        <translation>最新</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>上</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>warm air</source>
        <translation>熱気</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>weld</source>
        <translation>溶着線</translation>
    </message>
    <message>
        <source>weld inside</source>
        <translation>内側の溶着線</translation>
    </message>
    <message>
        <source>welding error</source>
        <translation>溶着の誤差</translation>
    </message>
    <message>
        <source>what came out</source>
        <translation>結果</translation>
    </message>
    <message>
        <source>width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>width_mm must be above 0, and taper from 0.2 to 1.</source>
        <translation>width_mm は 0 より大きく、taper は 0.2～1 にしてください。</translation>
    </message>
    <message>
        <source>without a word</source>
        <translation>メッセージなし</translation>
    </message>
    <message>
        <source>wrinkled: {}</source>
        <translation>しわ：{}</translation>
    </message>
    <message>
        <source>writing files</source>
        <translation>ファイルを書き出しています</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>はい</translation>
    </message>
    <message>
        <source>{0} "{1}" is none of {2}.</source>
        <translation>{0}「{1}」は {2} のどれでもありません。</translation>
    </message>
    <message>
        <source>{0} ({1}, margin {2})</source>
        <translation>{0}（{1}、余裕 {2} 倍）</translation>
    </message>
    <message>
        <source>{0} It is left out.</source>
        <translation>{0} このファイルは無視します。</translation>
    </message>
    <message>
        <source>{0} and {1} lines meet near {2}: move the hole inward or make the allowance narrower.</source>
        <translation>{0} と {1} の線が {2} 付近で交わります。穴を内側へ移すか、余白を狭くしてください。</translation>
    </message>
    <message>
        <source>{0} at least {1}</source>
        <translation>{0}が {1} 以上</translation>
    </message>
    <message>
        <source>{0} at most {1}</source>
        <translation>{0}が {1} 以下</translation>
    </message>
    <message>
        <source>{0} balloons cannot be laid out: give 1 or more.</source>
        <translation>風船 {0} 個は並べられません。1 個以上にしてください。</translation>
    </message>
    <message>
        <source>{0} begins in {1} and ends in {2}: write both in one unit.</source>
        <translation>{0} は {1} で始まり {2} で終わります。同じ単位で書いてください。</translation>
    </message>
    <message>
        <source>{0} belongs to no balloon: choose an outline, a balloon or a pattern.</source>
        <translation>{0} はどの風船のものでもありません。輪郭、風船、型紙のどれかを選んでください。</translation>
    </message>
    <message>
        <source>{0} cannot be "{1}": {2}</source>
        <translation>{0} を「{1}」にはできません：{2}</translation>
    </message>
    <message>
        <source>{0} cannot be deleted: {1}. See who may write there.</source>
        <translation>{0} を削除できません：{1}。その場所に書き込めるか確かめてください。</translation>
    </message>
    <message>
        <source>{0} cannot be loaded ({1}).</source>
        <translation>{0} を読み込めません（{1}）。</translation>
    </message>
    <message>
        <source>{0} cannot be read ({1}): write {2}.</source>
        <translation>{0} を読み取れません（{1}）。{2} のように書いてください。</translation>
    </message>
    <message>
        <source>{0} cannot be varied: choose a number, a word or a choice.</source>
        <translation>{0} は変えられません。数、言葉、選択肢のどれかを選んでください。</translation>
    </message>
    <message>
        <source>{0} cannot make crosses in the film to lay it on anew (layer REGISTRATION): choose another machine, or make the balloon smaller.</source>
        <translation>{0} はフィルムを置き直すための十字（レイヤー REGISTRATION）を付けられません。別の機械を選ぶか、風船を小さくしてください。</translation>
    </message>
    <message>
        <source>{0} cannot work: {1}</source>
        <translation>{0}が動作できません：{1}</translation>
    </message>
    <message>
        <source>{0} changed since. Choose Inflate now in its context menu, or switch Live on.</source>
        <translation>変わった値：{0}。コンテキストメニューで「今すぐふくらませる」を選ぶか、ライブをオンにしてください。</translation>
    </message>
    <message>
        <source>{0} does not have the native solver (answer {1}). Try again later. {2}</source>
        <translation>{0} にネイティブソルバーがありません（応答 {1}）。後でもう一度試してください。{2}</translation>
    </message>
    <message>
        <source>{0} does not see the folder '{1}': choose one that all machines share.</source>
        <translation>{0}からフォルダー「{1}」が見えません。すべてのマシンで共有しているフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>{0} dots per inch cannot be printed well: give {1} to {2}.</source>
        <translation>{0} dpi ではきれいに印刷できません。{1}～{2} にしてください。</translation>
    </message>
    <message>
        <source>{0} follows itself: choose something that is not made of it.</source>
        <translation>{0} が自分自身に従っています。それから作られていないものを選んでください。</translation>
    </message>
    <message>
        <source>{0} follows {1}: edit that.</source>
        <translation>{0} は {1} に追従しています。{1} を編集してください。</translation>
    </message>
    <message>
        <source>{0} gap between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>線の間のすき間を {0} か所閉じました。最大で図の幅の {1} です。</translation>
    </message>
    <message>
        <source>{0} gaps between the lines closed, the widest {1} of the drawing's width.</source>
        <translation>線の間のすき間を {0} か所閉じました。最大で図の幅の {1} です。</translation>
    </message>
    <message>
        <source>{0} goes up to {1}, and {2} bears {3}: give less.</source>
        <translation>{0} は {1} まで上がりますが、{2} が耐えるのは {3} までです。小さくしてください。</translation>
    </message>
    <message>
        <source>{0} has a point that is no number or farther away than {1}. Check its coordinates and the unit.</source>
        <translation>{0} に数でない点か、{1} より遠い点があります。座標と単位を確かめてください。</translation>
    </message>
    <message>
        <source>{0} has a speed and a power, which only layers below {1} of a LightBurn project have: remove them.</source>
        <translation>{0} に速度と出力がありますが、付けられるのは LightBurn プロジェクトの {1} より小さい番号のレイヤーだけです。外してください。</translation>
    </message>
    <message>
        <source>{0} has an error: repair it.</source>
        <translation>{0} に誤りがあります。直してください。</translation>
    </message>
    <message>
        <source>{0} has fewer than three points. Give all of its corners.</source>
        <translation>{0} の点が 3 つ未満です。角をすべて指定してください。</translation>
    </message>
    <message>
        <source>{0} has interface {1}, but {2} is needed.</source>
        <translation>{0} のインターフェースは {1} ですが、{2} が必要です。</translation>
    </message>
    <message>
        <source>{0} has no "{1}": it has {2}.</source>
        <translation>{0} に「{1}」はありません。使えるもの：{2}。</translation>
    </message>
    <message>
        <source>{0} has no area: all of its points lie on a line. Check its coordinates.</source>
        <translation>{0} に面積がありません。点がすべて一直線上にあります。座標を確かめてください。</translation>
    </message>
    <message>
        <source>{0} has no balloon: choose the one that is to be varied.</source>
        <translation>{0} に風船がありません。値を変えてみる風船を選んでください。</translation>
    </message>
    <message>
        <source>{0} has no drawing yet: choose a picture.</source>
        <translation>{0} にはまだ図がありません。画像を選んでください。</translation>
    </message>
    <message>
        <source>{0} has no outline to edit: choose a balloon from a picture.</source>
        <translation>{0} には編集できる輪郭がありません。画像から作った風船を選んでください。</translation>
    </message>
    <message>
        <source>{0} has no pattern: choose a balloon.</source>
        <translation>{0} に型紙がありません。風船を選んでください。</translation>
    </message>
    <message>
        <source>{0} has no piece {1}: its pieces are {2}.</source>
        <translation>{0} に部品 {1} はありません。部品は {2} です。</translation>
    </message>
    <message>
        <source>{0} has no result yet: recompute it.</source>
        <translation>{0} にはまだ結果がありません。再計算してください。</translation>
    </message>
    <message>
        <source>{0} has no room between its ends: write the smaller one first.</source>
        <translation>{0} の両端の間に範囲がありません。小さい方を先に書いてください。</translation>
    </message>
    <message>
        <source>{0} has no rows: write the values of each balloon below the headings.</source>
        <translation>{0} に行がありません。見出しの下に風船ごとの値を書いてください。</translation>
    </message>
    <message>
        <source>{0} has no shape. Choose a solid or a mesh.</source>
        <translation>{0} に形状がありません。ソリッドかメッシュを選んでください。</translation>
    </message>
    <message>
        <source>{0} has no shape: select a sketch, a wire or a face.</source>
        <translation>{0} に形状がありません。スケッチ、ワイヤー、面を選んでください。</translation>
    </message>
    <message>
        <source>{0} has no table: choose a spreadsheet of the document.</source>
        <translation>{0} に表がありません。ドキュメントの表計算シートを選んでください。</translation>
    </message>
    <message>
        <source>{0} has no values: write {1}.</source>
        <translation>{0} に値がありません。{1} のように書いてください。</translation>
    </message>
    <message>
        <source>{0} has not been built.</source>
        <translation>{0} はビルドされていません。</translation>
    </message>
    <message>
        <source>{0} has several faces: select one of them.</source>
        <translation>{0} には面が複数あります。一つを選んでください。</translation>
    </message>
    <message>
        <source>{0} has several faces: select those that are panels.</source>
        <translation>{0} には複数の面があります。パネルになる面を選んでください。</translation>
    </message>
    <message>
        <source>{0} has two columns for {1}: leave one out.</source>
        <translation>{0} には {1} の列が 2 つあります。一つを外してください。</translation>
    </message>
    <message>
        <source>{0} has version {1}, not {2}: install the same one everywhere.</source>
        <translation>{0}の版は {2} ではなく {1} です。すべてに同じ版を入れてください。</translation>
    </message>
    <message>
        <source>{0} has {1} bodies: choose one of them.</source>
        <translation>{0} には立体が {1} 個あります。1 つを選んでください。</translation>
    </message>
    <message>
        <source>{0} has {1} construction lines: leave one of them, which is the axis.</source>
        <translation>{0} には補助線が {1} 本あります。軸になる 1 本だけを残してください。</translation>
    </message>
    <message>
        <source>{0} has {1} pieces now: delete it.</source>
        <translation>{0} の部品は今 {1} 個です。これを削除してください。</translation>
    </message>
    <message>
        <source>{0} hole with a thin line round it was filled, as a pen's: choose Drawn as filled shape to keep it.</source>
        <translation>細い線で囲まれた穴を {0} 個、線画とみなして塗りました。残すには「描き方」を「塗った形」にしてください。</translation>
    </message>
    <message>
        <source>{0} holes with a thin line round them were filled, as a pen's: choose Drawn as filled shape to keep them.</source>
        <translation>細い線で囲まれた穴を {0} 個、線画とみなして塗りました。残すには「描き方」を「塗った形」にしてください。</translation>
    </message>
    <message>
        <source>{0} is a file</source>
        <translation>{0} はファイルです</translation>
    </message>
    <message>
        <source>{0} is a folder</source>
        <translation>{0} はフォルダーです</translation>
    </message>
    <message>
        <source>{0} is an edge of a hole: choose one of an outer loop as the opening.</source>
        <translation>{0} は穴の辺です。開口には外側の境界の辺を選んでください。</translation>
    </message>
    <message>
        <source>{0} is at an end of its range: a wider one may hold a better balloon.</source>
        <translation>{0} は範囲の端にあります。範囲を広げると、もっと良い風船が見つかるかもしれません。</translation>
    </message>
    <message>
        <source>{0} is curved both ways: it is cut into {1} strips.</source>
        <translation>{0} は 2 方向に曲がっているため、{1} 本の帯に切り分けます。</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete ({1}). Install the workbench anew.</source>
        <translation>{0} は壊れているか不完全です（{1}）。ワークベンチを入れ直してください。</translation>
    </message>
    <message>
        <source>{0} is damaged or incomplete. Install the workbench anew.</source>
        <translation>{0} は壊れているか不完全です。ワークベンチを入れ直してください。</translation>
    </message>
    <message>
        <source>{0} is damaged: install the workbench anew, or go on without the native solver.</source>
        <translation>{0} は壊れています。ワークベンチを入れ直すか、ネイティブソルバーなしで続けてください。</translation>
    </message>
    <message>
        <source>{0} is damaged: remove it and start the study again.</source>
        <translation>{0} は壊れています。削除して、スタディをもう一度始めてください。</translation>
    </message>
    <message>
        <source>{0} is empty: draw a closed line in it.</source>
        <translation>{0} は空です。閉じた線を描いてください。</translation>
    </message>
    <message>
        <source>{0} is empty: draw a line in it.</source>
        <translation>{0} が空です。その中に線を描いてください。</translation>
    </message>
    <message>
        <source>{0} is empty: draw half an outline in it, beside the vertical axis.</source>
        <translation>{0} は空です。縦の軸の横に輪郭の半分を描いてください。</translation>
    </message>
    <message>
        <source>{0} is hollow: choose a solid without a space inside.</source>
        <translation>{0} は中が空洞です。内側に空間のないソリッドを選んでください。</translation>
    </message>
    <message>
        <source>{0} is in no seam. Seal it to another edge.</source>
        <translation>{0} はどの継ぎ目にもありません。別の辺と溶着してください。</translation>
    </message>
    <message>
        <source>{0} is in no seam: join it to another edge.</source>
        <translation>{0} はどの継ぎ目にもありません。別の辺とつないでください。</translation>
    </message>
    <message>
        <source>{0} is in the document {1}: copy it into {2} first.</source>
        <translation>{0} は文書 {1} にあります。先に {2} へコピーしてください。</translation>
    </message>
    <message>
        <source>{0} is in two seams: take one of them away.</source>
        <translation>{0} は 2 つの継ぎ目にあります。どちらかを外してください。</translation>
    </message>
    <message>
        <source>{0} is left out. {1}</source>
        <translation>{0} は省かれました。{1}</translation>
    </message>
    <message>
        <source>{0} is neither DXF nor SVG: let the name end in .dxf or .svg.</source>
        <translation>{0} は DXF でも SVG でもありません。名前の末尾を .dxf か .svg にしてください。</translation>
    </message>
    <message>
        <source>{0} is neither VTU, NPZ nor STL: let the name end in .vtu, .npz or .stl.</source>
        <translation>{0} は VTU、NPZ、STL のどれでもありません。名前の末尾を .vtu、.npz、.stl にしてください。</translation>
    </message>
    <message>
        <source>{0} is no body: give a solid, a mesh or the path of a file.</source>
        <translation>{0} は立体ではありません。ソリッド、メッシュ、またはファイルのパスを渡してください。</translation>
    </message>
    <message>
        <source>{0} is no file for the web: let the name end in .glb, .html, .png, .gif or .mp4.</source>
        <translation>{0} はウェブ用のファイルではありません。名前の終わりを .glb、.html、.png、.gif、.mp4 のどれかにしてください。</translation>
    </message>
    <message>
        <source>{0} is no number</source>
        <translation>{0} は数ではありません</translation>
    </message>
    <message>
        <source>{0} is no number: list its values.</source>
        <translation>{0} は数ではありません。値を並べてください。</translation>
    </message>
    <message>
        <source>{0} is no number: write its values into the table.</source>
        <translation>{0} は数ではありません。値を表に書いてください。</translation>
    </message>
    <message>
        <source>{0} is none of the names that are known</source>
        <translation>{0} は知られた名前ではありません</translation>
    </message>
    <message>
        <source>{0} is not a coordinate</source>
        <translation>{0} は座標ではない</translation>
    </message>
    <message>
        <source>{0} is not closed: film can only be filled where it is. Choose a solid.</source>
        <translation>{0} は閉じていません。閉じていないとフィルムに空気を入れられません。ソリッドを選んでください。</translation>
    </message>
    <message>
        <source>{0} is not flat: a balloon is cut from flat film, so draw it in one plane.</source>
        <translation>{0} は平らではありません。風船は平らなフィルムから切るので、一つの平面に描いてください。</translation>
    </message>
    <message>
        <source>{0} is not flat: draw half the outline in a sketch.</source>
        <translation>{0} は平らではありません。輪郭の半分をスケッチに描いてください。</translation>
    </message>
    <message>
        <source>{0} is not joined by heat: {1} is not made for it.</source>
        <translation>{0} は熱で接合しません。{1} はそのための機械ではありません。</translation>
    </message>
    <message>
        <source>{0} is not printed on {1}: choose an artwork of this pattern.</source>
        <translation>{0} は {1} に印刷するものではありません。この型紙の絵柄を選んでください。</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1}</source>
        <translation>{0} は最新ではありません。{1}</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that and recompute.</source>
        <translation>{0} は最新ではありません。{1} それを直して再計算してください。</translation>
    </message>
    <message>
        <source>{0} is not up to date. {1} Repair that, recompute and export again.</source>
        <translation>{0} は最新ではありません。{1} それを直し、再計算してから書き出してください。</translation>
    </message>
    <message>
        <source>{0} is not worked out yet: recompute the document.</source>
        <translation>{0} はまだ計算されていません。ドキュメントを再計算してください。</translation>
    </message>
    <message>
        <source>{0} is open: close its line.</source>
        <translation>{0} は開いています。線を閉じてください。</translation>
    </message>
    <message>
        <source>{0} is too large a number, or none</source>
        <translation>{0} は大きすぎるか、数ではありません</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} is {3}: make them equally long.</source>
        <translation>{0} の長さは {1}、{2} は {3} です。同じ長さにしてください。</translation>
    </message>
    <message>
        <source>{0} is {1} long. Scale it, so that it is between {2} and {3}.</source>
        <translation>{0} の長さは {1} です。{2} から {3} の間になるように拡大・縮小してください。</translation>
    </message>
    <message>
        <source>{0} is {1}. Seal each edge once: side a goes along its loop from its first point to its second, b against it.</source>
        <translation>{0} は{1}。各辺は 1 回だけ溶着します。側 a は境界に沿って最初の点から次の点へ、b は逆向きに進みます。</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number from {2} to {3}.</source>
        <translation>{0} が {1} です。{2}～{3} の数にしてください。</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number, or [least, most].</source>
        <translation>{0} が {1} です。数か、[最小, 最大] にしてください。</translation>
    </message>
    <message>
        <source>{0} is {1}: give a number.</source>
        <translation>{0} が {1} です。数にしてください。</translation>
    </message>
    <message>
        <source>{0} is {1}: give numbers from {2} to {3}, the smaller one first.</source>
        <translation>{0} が {1} です。{2}～{3} の数を、小さい方を先にして指定してください。</translation>
    </message>
    <message>
        <source>{0} is {1}: give {2}, or leave it out.</source>
        <translation>{0} が {1} になっています。{2} を指定するか、外してください。</translation>
    </message>
    <message>
        <source>{0} is {1}: write it as {"value": ..., "source": "who says so"}.</source>
        <translation>{0} が {1} です。{"value": ..., "source": "出典"} のように書いてください。</translation>
    </message>
    <message>
        <source>{0} is {1}: write true or false.</source>
        <translation>{0} が {1} です。true か false にしてください。</translation>
    </message>
    <message>
        <source>{0} lacks its source: write who states it. What nobody states is left out.</source>
        <translation>{0} に出典がありません。誰が示した値かを書いてください。誰も示していない値は書きません。</translation>
    </message>
    <message>
        <source>{0} left out ({1}).</source>
        <translation>{0} を除きました（{1}）。</translation>
    </message>
    <message>
        <source>{0} lies on both sides of its axis: draw half the outline, on one side.</source>
        <translation>{0} は軸の両側にあります。輪郭の半分を片側に描いてください。</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no, at no size.</source>
        <translation>{0}の浮力は {1}、{2}。どの大きさでも浮きません。</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: no. From {3} width on it would.</source>
        <translation>{0}の浮力は {1}、{2}。浮きません。幅 {3} 以上なら浮きます。</translation>
    </message>
    <message>
        <source>{0} lifts {1}, {2}: yes, and it carries {3}.</source>
        <translation>{0}の浮力は {1}、{2}。浮きます。さらに {3} を持ち上げられます。</translation>
    </message>
    <message>
        <source>{0} mm on paper = {1} of film</source>
        <translation>紙の上の {0} mm = フィルムの {1}</translation>
    </message>
    <message>
        <source>{0} mm with an error of {1} mm</source>
        <translation>{0} mm（誤差 {1} mm）</translation>
    </message>
    <message>
        <source>{0} must never be cut with a laser: choose a machine with a knife.</source>
        <translation>{0} は絶対にレーザーで切ってはいけません。刃で切る機械を選んでください。</translation>
    </message>
    <message>
        <source>{0} needs a unit: write {1} instead of {2}.</source>
        <translation>{0} には単位が要ります。{2} ではなく {1} のように書いてください。</translation>
    </message>
    <message>
        <source>{0} never gets from '{1}' to '{2}' by '{3}'.</source>
        <translation>{0} は「{1}」から「{3}」刻みでは「{2}」に届きません。</translation>
    </message>
    <message>
        <source>{0} notches are closer than {1}: take fewer.</source>
        <translation>{0} 個の合印では間隔が {1} より狭くなります。減らしてください。</translation>
    </message>
    <message>
        <source>{0} of a roll {1} wide</source>
        <translation>幅 {1} のロールを {0}</translation>
    </message>
    <message>
        <source>{0} of its size</source>
        <translation>大きさの {0}</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give [width, height], or leave it out.</source>
        <translation>印の {0} が {1} です。[幅, 高さ] にするか、外してください。</translation>
    </message>
    <message>
        <source>{0} of marks is {1}: give a number from {2} to {3}.</source>
        <translation>印の {0} が {1} です。{2}～{3} の数にしてください。</translation>
    </message>
    <message>
        <source>{0} of {1} cannot be {2}: take another value.</source>
        <translation>{1} の {0} は {2} にできません: 別の値にしてください。</translation>
    </message>
    <message>
        <source>{0} of {1} follows the expression '{2}': vary what that is made of.</source>
        <translation>{1} の {0} は式「{2}」で決まります。式が参照する値を変えてください。</translation>
    </message>
    <message>
        <source>{0} of {1} is {2}, but its expression '{3}' gives {4}: change the expression.</source>
        <translation>{1} の {0} は{2}ですが、式「{3}」の値は{4}です。式を変えてください。</translation>
    </message>
    <message>
        <source>{0} open line was left out.</source>
        <translation>閉じていない線を {0} 本除きました。</translation>
    </message>
    <message>
        <source>{0} open lines were left out.</source>
        <translation>閉じていない線を {0} 本除きました。</translation>
    </message>
    <message>
        <source>{0} over {1}</source>
        <translation>{0}（横軸：{1}）</translation>
    </message>
    <message>
        <source>{0} panels meet at one point, which no weld closes: seal the cap from the sheet over it, or tape it.</source>
        <translation>{0} 枚のパネルが 1 点に集まり、溶着では閉じません。シートのキャップを上から溶着するか、テープで留めてください。</translation>
    </message>
    <message>
        <source>{0} reads no G-code: choose a machine that does.</source>
        <translation>{0} は G コードを読みません: 読める機械を選んでください。</translation>
    </message>
    <message>
        <source>{0} reads {1}, which has no pages: choose paper.</source>
        <translation>{0} が読むのは {1} で、ページがありません。用紙を選んでください。</translation>
    </message>
    <message>
        <source>{0} runs between two ends: say how to take samples in "{1}".</source>
        <translation>{0} は両端の間を動きます。サンプルの取り方を「{1}」に書いてください。</translation>
    </message>
    <message>
        <source>{0} seams cannot be sealed lying flat, least of all seam {1} of panels {2}: one edge turns by {3} in all to follow the other. Seal them bit by bit, or round the corners.</source>
        <translation>継ぎ目 {0} 本は平らに溶着できません。最も難しいのはパネル {2} の継ぎ目 {1} で、片方の辺がもう一方に沿うのに全部で {3} 回ります。少しずつ溶着するか、角を丸くしてください。</translation>
    </message>
    <message>
        <source>{0} small speck was dropped.</source>
        <translation>小さな点を {0} 個除きました。</translation>
    </message>
    <message>
        <source>{0} small specks were dropped.</source>
        <translation>小さな点を {0} 個除きました。</translation>
    </message>
    <message>
        <source>{0} takes from 1 to {1} equal parts, not '{2}'.</source>
        <translation>{0} の等分数は「{2}」ではなく、1 から {1} までです。</translation>
    </message>
    <message>
        <source>{0} thin line is</source>
        <translation>細い線 {0} 本</translation>
    </message>
    <message>
        <source>{0} thin lines are</source>
        <translation>細い線 {0} 本</translation>
    </message>
    <message>
        <source>{0} times</source>
        <translation>{0} 倍</translation>
    </message>
    <message>
        <source>{0} tiny hole was filled.</source>
        <translation>ごく小さな穴を {0} 個ふさぎました。</translation>
    </message>
    <message>
        <source>{0} tiny holes were filled.</source>
        <translation>ごく小さな穴を {0} 個ふさぎました。</translation>
    </message>
    <message>
        <source>{0} turns a minute</source>
        <translation>毎分 {0} 回転</translation>
    </message>
    <message>
        <source>{0} was left out. {1}</source>
        <translation>{0} を省きました。{1}</translation>
    </message>
    <message>
        <source>{0} weld outside the shapes left out.</source>
        <translation>形の外の溶着線を {0} 本除きました。</translation>
    </message>
    <message>
        <source>{0} welds outside the shapes left out.</source>
        <translation>形の外の溶着線を {0} 本除きました。</translation>
    </message>
    <message>
        <source>{0} wide, {1} long</source>
        <translation>幅 {0}、長さ {1}</translation>
    </message>
    <message>
        <source>{0} with an error of {1}</source>
        <translation>{0}（誤差 {1}）</translation>
    </message>
    <message>
        <source>{0} with valve {1}</source>
        <translation>{0}（弁 {1} を含む）</translation>
    </message>
    <message>
        <source>{0}, inflated: {1}</source>
        <translation>{0}、ふくらませた状態：{1}</translation>
    </message>
    <message>
        <source>{0}: '{1}' is no number, write one such as 20.</source>
        <translation>{0}：'{1}' は数ではありません。20 のように書いてください。</translation>
    </message>
    <message>
        <source>{0}: it is split over several files. Cut them in their order, and lay the film on anew each time so that its crosses are where the next file has them.</source>
        <translation>{0}。複数のファイルに分けます。順番に切り、そのつど、十字が次のファイルの十字の位置に来るようにフィルムを置き直してください。</translation>
    </message>
    <message>
        <source>{0}: its file lacks {1}: add it.</source>
        <translation>{0}：ファイルに {1} がありません。加えてください。</translation>
    </message>
    <message>
        <source>{0}: lay its pieces out on sheets of that size, make the balloon smaller, or write the file anyway.</source>
        <translation>{0}。部品をその大きさのシートに並べるか、風船を小さくするか、そのまま書き出してください。</translation>
    </message>
    <message>
        <source>{0}: make the balloon smaller, choose another machine or paper, or write the file anyway.</source>
        <translation>{0}。風船を小さくするか、別の機械か用紙を選ぶか、そのまま書き出してください。</translation>
    </message>
    <message>
        <source>{0}: the file is written anyway.</source>
        <translation>{0}。そのまま書き出します。</translation>
    </message>
    <message>
        <source>{0}: what changes it most</source>
        <translation>{0}：最も影響の大きいもの</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
    <message>
        <source>{0}: {1} mm is out of range, give {2} to {3} mm.</source>
        <translation>{0}：{1} mm は範囲外です。{2}～{3} mm にしてください。</translation>
    </message>
    <message>
        <source>{0}; wider than the usual roll</source>
        <translation>{0}、通常のロールより広い</translation>
    </message>
    <message>
        <source>{0}take a drawing, without a side band or gores.</source>
        <translation>{0}側面の帯やゴアのない図を使ってください。</translation>
    </message>
    <message>
        <source>{0}this drawing has {1} shapes, study one at a time.</source>
        <translation>{0}この図には {1} 個の形があります。一つずつ調べてください。</translation>
    </message>
    <message>
        <source>{0}what is shown is the last good state. Lower the pressure or change the mesh size.</source>
        <translation>{0}表示は最後の良い状態です。圧力を下げるか、メッシュの大きさを変えてください。</translation>
    </message>
    <message>
        <source>{0}{1} has no length. Take one of its points out.</source>
        <translation>{0}{1} に長さがありません。点を 1 つ取り除いてください。</translation>
    </message>
    <message>
        <source>{} (unusable)</source>
        <translation>{}（使えません）</translation>
    </message>
    <message>
        <source>{} ({})</source>
        <translation>{}（{}）</translation>
    </message>
    <message>
        <source>{} MB from {}; the file is checked before it is used, and nothing is sent.</source>
        <translation>{1} から {0} MB を取得します。ファイルは使う前に確かめます。こちらから送るデータはありません。</translation>
    </message>
    <message>
        <source>{} at ({})</source>
        <translation>{}（位置 {}）</translation>
    </message>
    <message>
        <source>{} gores are enough for {} of the profile's diagonal</source>
        <translation>断面の対角線の {1} にはゴア {0} 枚で足ります</translation>
    </message>
    <message>
        <source>{} gores, as many as {} of the profile's diagonal need</source>
        <translation>ゴア {0} 枚（断面の対角線の {1} に必要な数）</translation>
    </message>
    <message>
        <source>{} in the mean, at most {}</source>
        <translation>平均 {}、最大 {}</translation>
    </message>
    <message>
        <source>{} inside</source>
        <translation>内側 {}</translation>
    </message>
    <message>
        <source>{} is among the films</source>
        <translation>{} がフィルムの一覧に入りました</translation>
    </message>
    <message>
        <source>{} is among the machines of Export pattern</source>
        <translation>{} が「型紙を書き出す」の機械に入りました</translation>
    </message>
    <message>
        <source>{} is in the tree</source>
        <translation>{} がツリーに入りました</translation>
    </message>
    <message>
        <source>{} is there already: give another name.</source>
        <translation>{} はすでにあります。別の名前にしてください。</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the file", or give another name.</source>
        <translation>{} はすでにあります。「ファイルを置き換える」にチェックを入れるか、別の名前にしてください。</translation>
    </message>
    <message>
        <source>{} is there already: tick "Replace the files", or choose another folder.</source>
        <translation>{} はすでにあります。「既存のファイルを置き換える」にチェックを入れるか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>{} ms, {}, frame {} of {}</source>
        <translation>{} ms、{}、コマ {}/{}</translation>
    </message>
    <message>
        <source>{} of it wrinkles, {} is loose</source>
        <translation>しわ {}、たるみ {}</translation>
    </message>
    <message>
        <source>{} of the profile's diagonal take {} gores</source>
        <translation>断面の対角線の {0} にはゴア {1} 枚が必要です</translation>
    </message>
    <message>
        <source>{} of them cannot be made:</source>
        <translation>うち {} 行は風船を作れません：</translation>
    </message>
    <message>
        <source>{} of {}</source>
        <translation>{} の{}</translation>
    </message>
    <message>
        <source>{} of {} rows are worked out.</source>
        <translation>{1} 行のうち {0} 行を計算しました。</translation>
    </message>
    <message>
        <source>{} outside</source>
        <translation>外側 {}</translation>
    </message>
    <message>
        <source>{} panels, {} of seams, {} inside</source>
        <translation>パネル {} 枚、継ぎ目 {}、内側 {}</translation>
    </message>
    <message>
        <source>{} panels, {} seams of {}</source>
        <translation>パネル {} 枚、継ぎ目 {} 本、全長 {}</translation>
    </message>
    <message>
        <source>{} panels: about {} off, {} of seams, {} h of welding</source>
        <translation>パネル {} 枚：ずれ約 {}、継ぎ目 {}、溶着 {} 時間</translation>
    </message>
    <message>
        <source>{} px</source>
        <translation>{} px</translation>
    </message>
    <message>
        <source>{} to {}</source>
        <translation>{}～{}</translation>
    </message>
    <message>
        <source>{} x {}, {} thick, {}</source>
        <translation>{} x {}、厚み {}、{}</translation>
    </message>
    <message>
        <source>{}, at most {}</source>
        <translation>{}、最大 {}</translation>
    </message>
    <message>
        <source>{}, carries {} with {}</source>
        <translation>{0}、{2}で {1} を持ち上げる</translation>
    </message>
    <message>
        <source>{}, floats from {} width on with {}</source>
        <translation>{0}、{2}なら幅 {1} 以上で浮く</translation>
    </message>
    <message>
        <source>{}, never floats with {}</source>
        <translation>{}、{}では浮かない</translation>
    </message>
    <message>
        <source>{}, row {}</source>
        <translation>{}、{} 行</translation>
    </message>
    <message>
        <source>{}, seam {}</source>
        <translation>{}、継ぎ目 {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}</source>
        <translation>{}：フィルム {}、継ぎ目と首 {}</translation>
    </message>
    <message>
        <source>{}: film {}, seam and neck {}, valve {}</source>
        <translation>{}：フィルム {}、継ぎ目と首 {}、弁 {}</translation>
    </message>
    <message>
        <source>{}: they differ by {}</source>
        <translation>{}：差は {}</translation>
    </message>
    <message>
        <source>{}: {}</source>
        <translation>{}：{}</translation>
    </message>
    <message>
        <source>{}: {}, flat</source>
        <translation>{}: {}、平ら</translation>
    </message>
    <message>
        <source>{}: {}, nodes</source>
        <translation>{}: {}、ノード</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Advice</name>
    <message>
        <source>Advice</source>
        <translation>助言</translation>
    </message>
    <message>
        <source>Show which parts of a shape will inflate badly, and repair them</source>
        <translation>うまくふくらまない部分を示し、直す</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Animate</name>
    <message>
        <source>Animate inflation</source>
        <translation>膨張のアニメーション</translation>
    </message>
    <message>
        <source>Play how the balloon inflates, from the flat film to rest, with a slider</source>
        <translation>平らなフィルムから静止するまで、風船がふくらむ様子をスライダー付きで再生する</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Artwork</name>
    <message>
        <source>Artwork</source>
        <translation>絵柄</translation>
    </message>
    <message>
        <source>Print a picture on the film so that it reads right on the inflated balloon</source>
        <translation>ふくらませたときに正しく見えるように、絵をフィルムに印刷する</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_AssemblySheet</name>
    <message>
        <source>Assembly sheet</source>
        <translation>組み立て図</translation>
    </message>
    <message>
        <source>Tell what the balloon takes and whether it floats, and write one page on how to make it</source>
        <translation>風船に必要なものと浮くかどうかを示し、作り方を 1 ページにまとめる</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ColourMap</name>
    <message>
        <source>Colour map</source>
        <translation>カラーマップ</translation>
    </message>
    <message>
        <source>Show tension, wrinkles, thickness and other results as colours on the balloon</source>
        <translation>張力、しわ、厚みなどの結果を風船の上に色で示す</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Compare</name>
    <message>
        <source>Compare with a photograph</source>
        <translation>写真と比べる</translation>
    </message>
    <message>
        <source>Lay a photograph of the finished balloon over the simulated one, and see how near it came</source>
        <translation>できた風船の写真をシミュレーションに重ね、どれだけ近いかを見る</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_EditOutline</name>
    <message>
        <source>Edit outline</source>
        <translation>輪郭を編集</translation>
    </message>
    <message>
        <source>Move, add and remove nodes of the outline over its picture, and set how the picture is read</source>
        <translation>画像の上で輪郭のノードを動かし、加え、消します。画像の読み取り方も設定できます</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Equipment</name>
    <message>
        <source>Show the solver in use, and which packages are missing and what that costs</source>
        <translation>使っているソルバーと、足りないパッケージとその影響を示す</translation>
    </message>
    <message>
        <source>What works here</source>
        <translation>この環境で使えるもの</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Examples</name>
    <message>
        <source>Examples</source>
        <translation>例</translation>
    </message>
    <message>
        <source>Open a finished balloon, to look at it and to change it</source>
        <translation>完成した風船を開いて、見たり変えたりする</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportForWeb</name>
    <message>
        <source>Export for the web</source>
        <translation>ウェブ用に書き出す</translation>
    </message>
    <message>
        <source>Write the balloon with its artwork as a web page that turns it, as a 3D model or as a picture</source>
        <translation>印刷つきの風船を、回せるウェブページ、3D モデル、または画像として書き出します</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_ExportPattern</name>
    <message>
        <source>Export pattern</source>
        <translation>型紙を書き出す</translation>
    </message>
    <message>
        <source>Write the flat pattern of a balloon for a cutter, a plotter, a heat sealer or a printer</source>
        <translation>風船の平らな型紙を、カッター、プロッター、ヒートシーラー、プリンター用に書き出す</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromBody</name>
    <message>
        <source>Find the panels of a balloon that fills the selected solid or mesh</source>
        <translation>選んだソリッドまたはメッシュを満たす風船のパネルを求めます</translation>
    </message>
    <message>
        <source>New balloon from body</source>
        <translation>立体から新しい風船</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPanels</name>
    <message>
        <source>New bag of panels</source>
        <translation>新しいパネルの袋</translation>
    </message>
    <message>
        <source>Seal flat panels along their edges: selected sketches and faces, a ready body or a file</source>
        <translation>平らなパネルを辺でつなぎます：選んだスケッチと面、既製の立体、またはファイル</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromPicture</name>
    <message>
        <source>New balloon from picture</source>
        <translation>画像から新しい風船</translation>
    </message>
    <message>
        <source>Trace a picture, SVG, DXF or JSON file and design the balloon that looks like it</source>
        <translation>画像、SVG、DXF、JSON をなぞり、それと同じ形に見える風船を設計する</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromProfile</name>
    <message>
        <source>Design the gores of a ball, an airship or another round body from half its outline</source>
        <translation>輪郭の半分から、ボールや飛行船などの丸い立体のゴアを設計します</translation>
    </message>
    <message>
        <source>New body of gores</source>
        <translation>新しいゴアの立体</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_FromSketch</name>
    <message>
        <source>Design the balloon that looks like the selected sketch, wire or face and follows it</source>
        <translation>選んだスケッチ、ワイヤー、面と同じ形に見え、それに追従する風船を設計する</translation>
    </message>
    <message>
        <source>New balloon from sketch</source>
        <translation>スケッチから新しい風船</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Machines</name>
    <message>
        <source>My machines</source>
        <translation>自分の機械</translation>
    </message>
    <message>
        <source>Set up cutters, lasers, sealers and printers of your own: bed, file format, kerf, knife and tool</source>
        <translation>自分のカッター、レーザー、シーラー、プリンターを設定する：加工台、ファイル形式、切り幅、刃、工具</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Nest</name>
    <message>
        <source>Lay out on film</source>
        <translation>フィルムに並べる</translation>
    </message>
    <message>
        <source>Lay the panels of one or several balloons closely on a roll or on sheets of film</source>
        <translation>一つまたは複数の風船の部品を、ロールやシートに詰めて並べる</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Paint</name>
    <message>
        <source>Draw with pen and brush, and watch the balloon and its pattern grow beside it</source>
        <translation>ペンとブラシで描き、隣で風船と型紙ができていくのを見る</translation>
    </message>
    <message>
        <source>Paint a balloon</source>
        <translation>風船を描く</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_PatternView</name>
    <message>
        <source>Pattern view</source>
        <translation>型紙の表示</translation>
    </message>
    <message>
        <source>Show all panels flat in a tab of their own: pick an edge to see its partner, and measure</source>
        <translation>すべてのパネルを別のタブに平らに表示します。辺を選ぶと相手の辺が分かり、長さも測れます</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_Study</name>
    <message>
        <source>Study</source>
        <translation>スタディ</translation>
    </message>
    <message>
        <source>Work out many variants of a balloon from a spreadsheet, and compare them</source>
        <translation>表計算シートから風船の案をいくつも計算し、比べる</translation>
    </message>
</context>
<context>
    <name>BalloonWorkbench_TestCard</name>
    <message>
        <source>Find feed, power, temperature or depth of a tool for a film: weld or cut a card of fields</source>
        <translation>フィルムに合う工具の送り速度、出力、温度、深さを見つける：欄を並べたカードを溶着または切る</translation>
    </message>
    <message>
        <source>Test card</source>
        <translation>テストカード</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Film &amp;Balloon</source>
        <translation>フィルム風船(&amp;B)</translation>
    </message>
    <message>
        <source>Film Balloon</source>
        <translation>フィルム風船</translation>
    </message>
</context>
</TS>
