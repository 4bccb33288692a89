# SPDX-License-Identifier: BSD-3-Clause
"""ask.py METHOD PATH [body]: prints what luxpipe-live answers to its page; the file "said" has its address."""

import re
import sys
import urllib.request

with open('said') as said: host, token = re.search(r'(http://[^/]+)/#(\w+)', said.read()).groups()
body = sys.argv[3].encode() if len(sys.argv) > 3 else None
sys.stdout.buffer.write(urllib.request.urlopen(urllib.request.Request(
    host + sys.argv[2], method=sys.argv[1], data=body, headers={'X-Luxpipe-Token': token})).read() + b'\n')
