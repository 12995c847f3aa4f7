"""Audits DXF files with ezdxf; prints what it found and read as a JSON list, one object for each file named.

Layers, rooms and texts are what a reader of the drawing would find: net areas are measured from the closed polylines
on A-AREA, holes subtracted.
"""

import json
import sys

try:
    import ezdxf
    from ezdxf.lldxf.encoding import decode_dxf_unicode
    from ezdxf.lldxf.tagger import ascii_tags_loader
    from ezdxf.tools.text import plain_text
except ImportError:
    sys.exit("ezdxf is missing: run `python3 -m pip install ezdxf==1.4.5`")


def whole(text):
    """Resolves `\\U+hhhh`, which `ezdxf.readfile` leaves to the caller, and joins surrogate pairs."""
    return decode_dxf_unicode(text).encode("utf-16", "surrogatepass").decode("utf-16")


def xdata(entity):
    values = [tag.value for tag in entity.get_xdata("PLANFORM")]
    return dict(zip(values[0::2], values[1::2]))


def points_of(ring):
    if ring.dxftype() == "LWPOLYLINE":
        return [(x, y) for x, y, *_ in ring.get_points()]
    return [(v.dxf.location.x, v.dxf.location.y) for v in ring.vertices]


def shoelace(points):
    (ox, oy) = points[0]
    local = [(x - ox, y - oy) for x, y in points]
    return abs(sum(a * d - c * b for (a, b), (c, d) in zip(local, local[1:] + local[:1]))) / 2


def rooms(model):
    found = {}
    for ring in model.query("LWPOLYLINE POLYLINE"):
        if ring.dxf.layer != "A-AREA":
            continue
        assert ring.is_closed, ring
        data = xdata(ring)
        sign = 1 if data["ring"] == "outer" else -1
        room = found.setdefault(str(data["room"]), {"area": 0.0, "said": data["area"], "name": None})
        room["area"] += sign * shoelace(points_of(ring))
        if "name" in data:
            room["name"] = whole(data["name"])
    return found


def repeated_handles(path, encoding):
    with open(path, encoding=encoding, errors="surrogateescape") as stream:
        tags = list(ascii_tags_loader(stream))
    seed = tags.index((9, "$HANDSEED")) + 1
    handles = [v for i, (c, v) in enumerate(tags) if c in (5, 105) and i != seed]
    above = [h for h in handles if int(h, 16) >= int(tags[seed][1], 16)]
    return len(handles) - len(set(handles)) + len(above)


def audit(path):
    doc = ezdxf.readfile(path)
    auditor = doc.audit()
    model = doc.modelspace()
    view = doc.viewports.get("*Active")[0]
    return {
        "version": doc.acad_release,
        "errors": [e.message for e in auditor.errors],
        "fixes": [e.message for e in auditor.fixes],
        "repeated_handles": repeated_handles(path, doc.output_encoding),
        "units": doc.units,
        "rooms": rooms(model),
        "texts": [plain_text(whole(t.dxf.text)) for t in model.query("TEXT")],
        "inserts": sorted(e.dxf.name for e in model.query("INSERT")),
        "arcs": [[*e.dxf.center.xyz[:2], e.dxf.radius, e.dxf.start_angle, e.dxf.end_angle] for e in model.query("ARC")],
        "layers": sorted({e.dxf.layer for e in model}),
        "known_layers": sum(layer.dxf.name.startswith("A-") for layer in doc.layers),
        "entities": len(model),
        "extents": [list(doc.header["$EXTMIN"]), list(doc.header["$EXTMAX"])],
        "view": [view.dxf.center[0], view.dxf.center[1], view.dxf.height, view.dxf.aspect_ratio],
    }


if __name__ == "__main__":
    print(json.dumps([audit(path) for path in sys.argv[1:]]))
