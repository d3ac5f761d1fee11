//! The block triangular form of a matrix (Duff and Reid 1978): an order of blocks, each of which contains unknowns of its own and of
//! earlier blocks.

use symbolic::Sym;

/// Returns the blocks in order, each as pairs (row, column). A matrix without a perfect matching yields fewer rows.
pub(super) fn of(matrix: &[Vec<Sym>], rows: &[usize], columns: &[usize]) -> Vec<Vec<(usize, usize)>> {
    let matched = matching(matrix, rows, columns);
    let k = matched.len();
    // whether a row depends on the unknown of another row, directly or indirectly (transitive closure)
    let mut needs: Vec<Vec<bool>> = matched
        .iter()
        .map(|&(row, _)| matched.iter().map(|&(_, other)| matrix[row][other] != Sym::ZERO).collect())
        .collect();
    for by in 0..k {
        for from in 0..k {
            if needs[from][by] {
                let further = needs[by].clone();
                needs[from].iter_mut().zip(further).for_each(|(needs, further)| *needs |= further);
            }
        }
    }
    let mut order: Vec<usize> = (0..k).collect();
    // a row depends on more rows than each row it depends on, except within its own block
    order.sort_by_key(|&each| needs[each].iter().filter(|needs| **needs).count());
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for each in order {
        match blocks.iter_mut().find(|block| needs[each][block[0]] && needs[block[0]][each]) {
            Some(block) => block.push(each),
            None => blocks.push(vec![each]),
        }
    }
    blocks.into_iter().map(|block| block.into_iter().map(|each| matched[each]).collect()).collect()
}

/// Returns a maximum matching, pairs (row, column) of nonzero entries, by augmenting paths.
fn matching(matrix: &[Vec<Sym>], rows: &[usize], columns: &[usize]) -> Vec<(usize, usize)> {
    let mut row_of: Vec<Option<usize>> = vec![None; columns.len()];
    for &row in rows {
        let mut visited = vec![false; columns.len()];
        augment(matrix, columns, row, &mut visited, &mut row_of);
    }
    let pairs = columns.iter().zip(row_of);
    pairs.filter_map(|(&column, row)| row.map(|row| (row, column))).collect()
}

fn augment(
    matrix: &[Vec<Sym>],
    columns: &[usize],
    row: usize,
    visited: &mut [bool],
    row_of: &mut [Option<usize>],
) -> bool {
    for (place, &column) in columns.iter().enumerate() {
        if matrix[row][column] == Sym::ZERO || std::mem::replace(&mut visited[place], true) {
            continue;
        }
        let is_free = match row_of[place] {
            None => true,
            Some(other) => augment(matrix, columns, other, visited, row_of),
        };
        if is_free {
            row_of[place] = Some(row);
            return true;
        }
    }
    false
}
