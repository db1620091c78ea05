# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the constants of rubber for biface.

    hardness   the shear modulus from Shore A
    data       reads measured curves
    laws       the laws of rubber, their stresses and moduli
    fit        least squares
    stability  Drucker's condition
    text       what the command prints
    picture    curves of the laws beside the data
"""
