"""Cases of the sealed batches that can be made again, one module a batch."""
