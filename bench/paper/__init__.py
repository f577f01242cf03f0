"""The experiments of the paper, with today's rivals."""
