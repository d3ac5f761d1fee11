"""Roots modulo the primes of random points."""

import unittest

from verify.prime_field import PrimeField, prime, root_modulo


class RootsModuloPrimes(unittest.TestCase):
    def test_the_roots_of_small_numbers_have_values_at_every_point(self):
        for square in (2, 3, 5, 6, 7, 10, 11, 13):
            self.assertEqual(pow(PrimeField().root(square), 2, prime()), square)

    def test_a_root_is_found_exactly_where_there_is_one(self):
        for p in (17, 97, 193, 257):
            squares = {k * k % p for k in range(p)}
            for number in range(p):
                root = root_modulo(number, p)
                self.assertEqual(root is not None, number in squares)
                self.assertIn(root, (None, *(k for k in range(p) if k * k % p == number)))


if __name__ == "__main__":
    unittest.main()
