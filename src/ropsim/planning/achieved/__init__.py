"""What a planned motion achieves: zones that are flown, speeds that are reached, and what limits them."""
