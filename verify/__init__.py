"""An independent checker of the certificates that `dalembert ledger` and `dalembert judge` write."""
