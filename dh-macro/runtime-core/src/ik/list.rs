//! A list of bounded length that lives where it is declared.

/// Up to `K` items; what does not fit is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct List<T, const K: usize> {
    items: [T; K],
    len: usize,
}

/// Builds an array place by place, in a loop, where the compiler sees that no index is out of
/// bounds. (`core::array::from_fn` may leave its closure a call, and the check in it.)
#[inline(always)]
pub(super) fn each<T: Copy, const K: usize>(filler: T, mut f: impl FnMut(usize) -> T) -> [T; K] {
    let mut out = [filler; K];
    for (i, place) in out.iter_mut().enumerate() {
        *place = f(i);
    }
    out
}

impl<T: Copy, const K: usize> List<T, K> {
    #[inline(always)]
    pub(super) fn new(filler: T) -> Self {
        Self { items: [filler; K], len: 0 }
    }

    /// Adds an item; false where there is no room.
    #[inline]
    pub(super) fn push(&mut self, item: T) -> bool {
        match self.items.get_mut(self.len) {
            Some(place) => {
                *place = item;
                self.len += 1;
                true
            }
            None => false,
        }
    }

    /// The items.
    #[inline]
    pub fn as_slice(&self) -> &[T] {
        self.items.get(..self.len).unwrap_or(&[])
    }

    #[inline]
    pub(super) fn as_mut_slice(&mut self) -> &mut [T] {
        self.items.get_mut(..self.len).unwrap_or(&mut [])
    }
}

impl<T: Copy, const K: usize> IntoIterator for List<T, K> {
    type Item = T;
    type IntoIter = core::iter::Take<core::array::IntoIter<T, K>>;
    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter().take(self.len)
    }
}

impl<T: Copy, const K: usize> core::ops::Deref for List<T, K> {
    type Target = [T];
    fn deref(&self) -> &[T] {
        self.as_slice()
    }
}
