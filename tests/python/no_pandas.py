# SPDX-License-Identifier: LGPL-2.1-or-later

# Without pandas, to_pandas() says in one sentence what to install.

import sys

import numpy as np

from python_test import biface, check, error_of

sys.modules["pandas"] = None
table = biface.Table({"force": np.array([1.])})
message = str(error_of(biface.BifaceError, table.to_pandas))
check("python3-pandas" in message, message)
