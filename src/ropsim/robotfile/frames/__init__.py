"""Robot files whose joints stand by their frames: branches, closed chains, joints of any type."""
