//! Drawings that would take time or memory without bound.

use planform_sdk::{ErrorKind, PluginError};
use resvg::usvg::{Group, Node as DrawnNode, Tree};
use roxmltree::{Document, Node};
use std::collections::HashMap;

/// The most elements that are drawn, those repeated by `use` and by markers counted each time.
const MAX_DRAWN: u64 = 2_000_000;
/// How deep elements may lie in each other.
const MAX_DEPTH: usize = 200;
/// How deep groups may lie in each other that are drawn on a picture of their own (transparency, masks, filters).
const MAX_LAYERS: usize = 16;
/// How deep `use` may lie in what is used.
const MAX_USES: usize = 32;
/// Bytes of path data that one corner takes at least.
const BYTES_PER_CORNER: u64 = 3;

/// Refuses documents that unfold to too much.
pub fn check_document(document: &Document<'_>) -> Result<(), PluginError> {
    let depths = depths(document);
    if depths.iter().any(|&d| d > MAX_DEPTH) {
        return Err(refuse(&format!("elements more than {MAX_DEPTH} deep in each other")));
    }
    let drawn = unfolded(document)?.saturating_add(markers(document));
    if drawn > MAX_DRAWN {
        return Err(refuse(&format!("more than {MAX_DRAWN} elements, once all repeated ones are drawn")));
    }
    Ok(())
}

/// Refuses drawings with too many pictures on top of each other.
pub fn check_tree(tree: &Tree) -> Result<(), PluginError> {
    match layers(tree.root()) {
        deep if deep > MAX_LAYERS => {
            Err(refuse(&format!("transparent groups more than {MAX_LAYERS} deep in each other")))
        }
        _ => Ok(()),
    }
}

/// The error of a drawing that holds this.
pub fn refuse(what: &str) -> PluginError {
    PluginError::new(ErrorKind::Limit, format!("the SVG is too complex to be drawn: it has {what}"))
        .advise("simplify it, or save it as a picture")
}

/// The depth of every node, in the order of the document.
fn depths(document: &Document<'_>) -> Vec<usize> {
    let mut depths: Vec<usize> = vec![];
    for node in document.descendants() {
        let parent = node.parent().and_then(|p| depths.get(index(p)));
        depths.push(parent.map_or(0, |d| d + 1));
    }
    depths
}

/// How many elements the whole document has with all that is used in its place. Each round lets uses see one level deeper.
fn unfolded(document: &Document<'_>) -> Result<u64, PluginError> {
    let nodes: Vec<_> = document.descendants().collect();
    let targets = targets(&nodes);
    let mut weights = vec![0_u64; nodes.len()];
    for _ in 0..MAX_USES {
        let before = weights.clone();
        weigh(&nodes, &targets, &before, &mut weights);
        let whole = weights.first().copied().unwrap_or_default();
        if weights == before || whole > MAX_DRAWN {
            return Ok(whole);
        }
    }
    Err(refuse(&format!("elements used by each other more than {MAX_USES} deep")))
}

fn weigh(nodes: &[Node<'_, '_>], targets: &[Option<usize>], before: &[u64], weights: &mut [u64]) {
    weights.fill(1);
    // Children come after their parents.
    for (i, node) in nodes.iter().enumerate().rev() {
        let used = targets[i].and_then(|t| before.get(t)).copied().unwrap_or_default();
        weights[i] = weights[i].saturating_add(used);
        if let Some(parent) = node.parent() {
            let own = weights[i];
            let sum = &mut weights[index(parent)];
            *sum = sum.saturating_add(own);
        }
    }
}

/// What the nodes that are `use` elements refer to.
fn targets(nodes: &[Node<'_, '_>]) -> Vec<Option<usize>> {
    let ids: HashMap<_, _> = nodes.iter().filter_map(|n| Some((n.attribute("id")?, index(*n)))).collect();
    let target = |node: &Node<'_, '_>| {
        let href = node.attributes().find(|a| a.name() == "href")?.value();
        (node.tag_name().name() == "use").then(|| ids.get(href.trim().strip_prefix('#')?).copied()).flatten()
    };
    nodes.iter().map(target).collect()
}

/// How many elements markers add if the largest of them stands at every corner.
fn markers(document: &Document<'_>) -> u64 {
    let largest = document
        .descendants()
        .filter(|n| n.tag_name().name() == "marker")
        .map(|m| m.descendants().count() as u64)
        .max()
        .unwrap_or_default();
    let data: u64 = document
        .descendants()
        .filter_map(|n| n.attribute("d").or_else(|| n.attribute("points")))
        .map(|d| d.len() as u64)
        .sum();
    largest.saturating_mul(data / BYTES_PER_CORNER)
}

fn index(node: Node<'_, '_>) -> usize {
    node.id().get_usize()
}

fn layers(group: &Group) -> usize {
    let below = |node: &DrawnNode| match node {
        DrawnNode::Group(g) => layers(g),
        _ => 0,
    };
    group.children().iter().map(below).max().unwrap_or_default() + usize::from(group.should_isolate())
}
