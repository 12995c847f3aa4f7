"""Reads a graph with networkx, and tells what is in it as JSON: its nodes, and how far it is between all of them."""

import json
import sys

try:
    import networkx as nx
except ImportError as e:
    sys.exit(f"this test needs {e.name}: python3 -m pip install networkx")


def read(path):
    if path.endswith(".graphml"):
        return nx.read_graphml(path)
    with open(path) as file:
        return nx.node_link_graph(json.load(file), edges="edges")


graph = read(sys.argv[1])
distances = dict(nx.all_pairs_dijkstra_path_length(graph, weight="distance"))
report = {
    "directed": graph.is_directed(),
    "multigraph": graph.is_multigraph(),
    "nodes": dict(graph.nodes(data=True)),
    "edges": graph.number_of_edges(),
    "distances": distances,
}
print(json.dumps(report, sort_keys=True))
