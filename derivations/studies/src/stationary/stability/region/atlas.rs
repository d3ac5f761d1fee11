//! A map as a set of branches. A branch is one steady motion continued from node to node; it has at most one motion at
//! each node.

use super::line::{Border, Link};
use super::node::{Class, Here, Node};
use std::collections::VecDeque;

/// All nodes, and the branches that join them.
#[derive(Clone, Debug)]
pub struct Atlas {
    /// The nodes, column by column, each column from its lowest row.
    pub columns: Vec<Vec<Node>>,
    /// The branches, in descending order of their number of nodes.
    pub branches: Vec<Branch>,
    /// The borders at which the verdict on a branch changes, or the branch ends, each with the index of its branch.
    pub borders: Vec<(usize, Border)>,
    /// The number of motions that could not be continued to a neighbour, although it has equally many motions.
    pub lost: usize,
}

/// One steady motion over the nodes to which it was continued.
#[derive(Clone, Debug)]
pub struct Branch {
    /// The index of the rotor's steady state.
    pub state: usize,
    /// The index of the motion among those of each node; `None` at nodes outside the branch.
    pub places: Vec<Vec<Option<usize>>>,
    /// The number of nodes of the branch.
    pub nodes: usize,
}

/// (column, row, index of the motion)
type At = (usize, usize, usize);

impl Atlas {
    /// The atlas from the links of each row, from left to right, and of each column, upwards.
    pub fn of(columns: Vec<Vec<Node>>, rows: Vec<Vec<Link>>, upwards: Vec<Vec<Link>>) -> Self {
        let mut next: Vec<Vec<Vec<Vec<At>>>> = columns
            .iter()
            .map(|column| column.iter().map(|node| vec![Vec::new(); node.isolated().len()]).collect())
            .collect();
        let mut borders: Vec<(At, Border)> = Vec::new();
        let mut lost = 0;
        let across = rows.into_iter().enumerate().flat_map(|(row, links)| {
            links.into_iter().enumerate().map(move |(column, link)| ([(column, row), (column + 1, row)], link))
        });
        let along = upwards.into_iter().enumerate().flat_map(|(column, links)| {
            links.into_iter().enumerate().map(move |(row, link)| ([(column, row), (column, row + 1)], link))
        });
        for (ends, link) in across.chain(along) {
            let at = |side: usize, place: usize| (ends[side].0, ends[side].1, place);
            for [i, j] in link.joined {
                let (a, b) = (at(0, i), at(1, j));
                next[a.0][a.1][i].push(b);
                next[b.0][b.1][j].push(a);
            }
            borders.extend(link.borders.into_iter().map(|border| (at(border.of.0, border.of.1), border)));
            lost += link.lost;
        }
        let mut number: Vec<Vec<Vec<Option<usize>>>> =
            next.iter().map(|column| column.iter().map(|node| vec![None; node.len()]).collect()).collect();
        let mut branches: Vec<Branch> = Vec::new();
        for column in 0..columns.len() {
            for row in 0..columns[column].len() {
                for place in 0..next[column][row].len() {
                    if number[column][row][place].is_none() {
                        let state = columns[column][row].isolated()[place].state;
                        let mut branch = Branch { state, places: empty(&columns), nodes: 0 };
                        branch.grow((column, row, place), branches.len(), &next, &mut number);
                        branches.push(branch);
                    }
                }
            }
        }
        let mut order: Vec<usize> = (0..branches.len()).collect();
        order.sort_by_key(|&k| (branches[k].state, std::cmp::Reverse(branches[k].nodes)));
        let rank = |k: usize| order.iter().position(|&other| other == k).unwrap_or(k);
        let of_branch =
            |((column, row, place), border): (At, Border)| Some((rank(number[column][row][place]?), border));
        let borders = borders.into_iter().filter_map(of_branch).collect();
        let branches = order.iter().map(|&k| branches[k].clone()).collect();
        Atlas { columns, branches, borders, lost }
    }

    /// The motion of a branch at a node.
    pub fn at(&self, branch: &Branch, column: usize, row: usize) -> Option<&Here> {
        self.columns[column][row].isolated().get(branch.places[column][row]?)
    }

    /// The number of nodes of a branch with each verdict.
    pub fn verdicts(&self, branch: &Branch) -> [usize; Class::ALL.len()] {
        let mut counts = [0; Class::ALL.len()];
        for (column, nodes) in self.columns.iter().enumerate() {
            for row in 0..nodes.len() {
                if let Some(here) = self.at(branch, column, row) {
                    let class = Class::from(here.verdict);
                    counts[Class::ALL.iter().position(|one| *one == class).unwrap_or(0)] += 1;
                }
            }
        }
        counts
    }
}

impl Branch {
    /// Extends the branch by breadth-first search; a node that it has reached is not entered again.
    fn grow(&mut self, from: At, own: usize, next: &[Vec<Vec<Vec<At>>>], number: &mut [Vec<Vec<Option<usize>>>]) {
        let mut open = VecDeque::from([from]);
        while let Some((column, row, place)) = open.pop_front() {
            if number[column][row][place].is_some() || self.places[column][row].is_some() {
                continue;
            }
            number[column][row][place] = Some(own);
            self.places[column][row] = Some(place);
            self.nodes += 1;
            open.extend(&next[column][row][place]);
        }
    }
}

fn empty(columns: &[Vec<Node>]) -> Vec<Vec<Option<usize>>> {
    columns.iter().map(|column| vec![None; column.len()]).collect()
}
